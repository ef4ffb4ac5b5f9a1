// Stars by direction.
#pragma once

#include <vector>

#include "compiler/sky/stars.h"
#include "preview/rgb.h"

namespace citykiln::preview {

/// Points of light in the sky, found by direction. A star is spread over a small disk, as the eye or a lens does.
class StarMap {
 public:
  StarMap() = default;
  explicit StarMap(std::vector<sky::Star> stars);

  /// Radiance of stars near a direction outside of the atmosphere, in sky::kUnitLuminance_cd_m2.
  /// @param pixel_rad  Angle of a pixel: a star's disk has this radius, within 0.0003 and 0.005, and its light in sum.
  Rgb radiance(Vec3 direction, double pixel_rad) const;

 private:
  std::vector<sky::Star> stars_;
  std::vector<std::vector<int>> cells_;  // of the stars whose largest disks touch them
};

}  // namespace citykiln::preview
