// The light of the stars by direction.
#pragma once

#include <vector>

#include "compiler/sky/stars.h"
#include "preview/rgb.h"

namespace citykiln::preview {

/// The stars of the sky, found by direction. Each star is spread over a small disk, as by the eye or a lens.
class StarMap {
 public:
  StarMap() = default;
  explicit StarMap(std::vector<sky::Star> stars);

  /// Returns the radiance of stars near a direction outside of the atmosphere, in sky::kUnitLuminance_cd_m2.
  /// @param pixel_rad  Angle of a pixel. A star's disk has this radius, limited to 0.0003 … 0.005 rad; its total light
  /// does not depend on the radius.
  Rgb radiance(Vec3 direction, double pixel_rad) const;

 private:
  std::vector<sky::Star> stars_;
  std::vector<std::vector<int>> cells_;  // the stars whose largest disks touch each cell
};

}  // namespace citykiln::preview
