// Shadows of clouds on what is below them, as a table.
#pragma once

#include <optional>
#include <vector>

#include "preview/clouds/cloud_field.h"

namespace citykiln::preview {

/// The share of the sun's light that passes clouds, at places of a level plane below them all. A place below the plane
/// has the share of the place where its ray to the sun meets the plane. Thread-safe.
class CloudShadow {
 public:
  /// Two tables around a place: of kNear_m to each side with cells of 32 m, about the width of a shadow's blurred edge
  /// for clouds 3 km up, and of kFar_m with cells of 256 m. Cost: a hundred thousand rays. Same bits for any number of
  /// threads.
  CloudShadow(const CloudField& field, Vec3 to_sun, Vec2 middle, int threads);

  /// Empty above the plane, and outside of the tables.
  std::optional<double> passed(Vec3 from) const;

 private:
  struct Table {
    double cell_m = 1;
    std::vector<float> passed;
  };
  Table table_of(const CloudField& field, double cell_m, int threads) const;

  Vec3 to_sun_;
  double plane_m_;
  Vec2 middle_;
  Table near_, far_;
};

}  // namespace citykiln::preview
