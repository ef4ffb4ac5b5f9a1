// The clouds around an eye as a table by direction, as fine as pixels.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "preview/clouds/cloud_field.h"

namespace citykiln::preview {

/// A table of the clouds that rays upwards from an eye meet. It has tiles of 16 by 16 directions. The first ray into a
/// tile computes it, later ones interpolate. Thread-safe; the same bits for any number of threads.
class CloudPanorama {
 public:
  /// @param field      Must outlive this object.
  /// @param eye        Plane metres.
  /// @param pixel_rad  The angle between neighbouring directions, at least 0.0002.
  CloudPanorama(const CloudField& field, Vec3 eye, double pixel_rad);

  /// Returns the clouds along an endless ray, interpolated between the directions of the table. A ray from another
  /// place than the eye gets those of the eye's ray to the point where it meets the lowest base. Returns nothing if the
  /// place or the eye is above the lowest base, if the direction does not go up, or if there are no clouds.
  std::optional<CloudPath> along(Vec3 from, Vec3 direction) const;
  Vec3 eye() const { return eye_; }

 private:
  struct Tile {
    std::once_flag is_made;
    std::vector<CloudPath> paths;  // row by row; distances are weighted by the opacity
  };
  struct Band {
    std::size_t first = 0;  // tile
    int tiles = 0;
  };
  const std::vector<CloudPath>& paths_of(const Band& band, int row, int column) const;

  const CloudField& field_;
  Vec3 eye_;
  double base_m_, row_rad_ = 1;
  std::vector<Band> bands_;
  std::unique_ptr<Tile[]> tiles_;
};

}  // namespace citykiln::preview
