// The shadows of clouds on everything below them, as a table.
#pragma once

#include <optional>
#include <vector>

#include "preview/clouds/cloud_field.h"

namespace citykiln::preview {

/// A table of the share of the sun's light that passes clouds, at places of a level plane below them all. The share at
/// a place below the plane is the share at the point where the ray from the place to the sun meets the plane.
/// Thread-safe.
class CloudShadow {
 public:
  /// Computes two tables of 256 by 256 cells about the place `middle`. Cells of 32 m are about as wide as a shadow's
  /// blurred edge for clouds 3 km up; cells of 256 m cover more ground. Where the sun is low (z < 0.05) there are no
  /// tables. Cost: a hundred thousand rays. Same bits for any number of threads.
  CloudShadow(const CloudField& field, Vec3 to_sun, Vec2 middle, int threads);

  /// Returns the share of the sun's light at a place (plane metres); empty above the plane and outside of the tables.
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
