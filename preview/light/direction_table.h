// A table of radiance by direction, from which directions are sampled.
#pragma once

#include <numbers>
#include <vector>

#include "compiler/geometry/vec.h"
#include "preview/rgb.h"
#include "preview/samples.h"

namespace citykiln::preview {

/// A sampled direction and its probability density per steradian.
struct DirectionSample {
  Vec3 direction;
  double pdf = 0;
};

/// The azimuth of a direction as a share of a full circle, in [0, 1), counter-clockwise from east.
double turn_of(Vec3 direction);

/// The unit vector with an azimuth, as in turn_of(), and a given z.
Vec3 direction_at(double turn, double z);

/// The partial sums of a series, for drawing one of its terms with a probability in proportion to its size. O(1) on
/// average.
class CumulativeSums {
 public:
  CumulativeSums() = default;
  explicit CumulativeSums(std::vector<double> terms);

  double total() const { return sums_.empty() ? 0 : sums_.back(); }
  struct Step {
    int index;
    double within;  ///< The position in the term, in [0, 1).
  };
  /// Returns the term that contains this share of the total.
  /// @param share  In [0, 1).
  Step at(double share) const;

 private:
  std::vector<double> sums_;
  std::vector<int> guide_;  // by equal parts of the total: the first term that may contain the part
};

/// Radiance in cells over all azimuths and a range of z. It is interpolated between the centres of cells; the density
/// of samples is constant in each cell.
class DirectionTable {
 public:
  /// @param z_edges  Limits of the rows in z, increasing, in [-1, 1]; at least two.
  /// @param cells    Row by row, from the lowest z.
  DirectionTable(std::vector<double> z_edges, int columns, std::vector<std::array<float, 3>> cells);

  /// The interpolated radiance; outside of the range of z, that of the nearest row.
  Rgb radiance(Vec3 direction) const;
  /// A sample in proportion to the cells' luminance; pdf 0 if all are black.
  DirectionSample sample(UnitPair chance) const;
  /// The density of sample() in a direction, per steradian; 0 outside of the range of z.
  double pdf(Vec3 direction) const;
  /// The sum of all cells' luminance times their solid angles.
  double flux() const { return row_sums_.total() * 2 * std::numbers::pi / columns_; }

 private:
  int row_of(double z) const;
  double pdf_of(const std::array<float, 3>& cell) const;
  int rows() const { return static_cast<int>(z_edges_.size()) - 1; }

  std::vector<double> z_edges_;
  int columns_;
  double pdf_per_light_ = 0;
  bool is_even_;  // all rows have the same height
  std::vector<std::array<float, 3>> cells_;
  CumulativeSums row_sums_;           // flux of rows
  std::vector<CumulativeSums> sums_;  // of cells within their row
};

}  // namespace citykiln::preview
