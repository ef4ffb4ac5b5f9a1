// The shadows of clouds on everything below them, as two tables: a fine one and a wide one.
#pragma once

#include <optional>
#include <vector>

#include "preview/clouds/cloud_field.h"

namespace citykiln::preview {

/// The share of the sun's light that passes clouds, in tables over a horizontal plane below all clouds. The share at a
/// place below the plane is the share at the point where the ray from the place to the sun meets the plane.
/// Thread-safe.
class CloudShadow {
 public:
  /// Computes two tables of 256 by 256 cells about the place `middle`. The cells of the first are 32 m wide, about as
  /// wide as a shadow's blurred edge for clouds 3 km up. The cells of the second are 256 m wide and cover more ground.
  /// If to_sun.z < 0.05 (the sun is less than 3° high) or there are no clouds, there are no tables, and passed() is
  /// always empty. Cost: a hundred thousand rays. Same bits for any number of threads.
  CloudShadow(const CloudField& field, Vec3 to_sun, Vec2 middle, int threads);

  /// Returns the share of the sun's light at a place (metres on the map plane, z up); empty above the plane and outside
  /// of the tables.
  std::optional<double> passed(Vec3 from) const;

 private:
  struct Table {
    double cell_m = 1;          ///< The side of a cell.
    std::vector<float> passed;  ///< The share of light at the centre of each cell, row by row; empty: no table.
  };
  Table table_of(const CloudField& field, double cell_m, int threads) const;

  Vec3 to_sun_;
  double plane_m_;
  Vec2 middle_;
  Table near_, far_;
};

}  // namespace citykiln::preview
