// A table of radiance by direction, from which directions are sampled. Directions are unit vectors with z up.
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

/// Returns the azimuth of a direction as a share of a full circle, in [0, 1), counter-clockwise from east.
double turn_of(Vec3 direction);

/// Returns the unit vector with an azimuth, as in turn_of(), and a given z.
Vec3 direction_at(double turn, double z);

/// The partial sums of a series, for drawing a term with a probability in proportion to the term.
class CumulativeSums {
 public:
  CumulativeSums() = default;
  explicit CumulativeSums(std::vector<double> terms);

  double total() const { return sums_.empty() ? 0 : sums_.back(); }
  struct Step {
    int index;      ///< The index of the term.
    double within;  ///< The position in the term, in [0, 1).
  };
  /// Returns the term in which the partial sum reaches this share of the total. O(1) on average.
  /// @param share  In [0, 1).
  Step at(double share) const;

 private:
  std::vector<double> sums_;
  std::vector<int> guide_;  // by equal parts of the total: the first term that may contain the part
};

/// Radiance in cells over all azimuths and a range of z. Radiance is interpolated between the centres of cells; the
/// density of samples is constant in each cell.
class DirectionTable {
 public:
  /// @param z_edges  Limits of the rows in z, increasing, in [-1, 1]; at least two.
  /// @param columns  The number of cells in a row; a row begins in the east and goes counter-clockwise.
  /// @param cells    Linear RGB radiance, row by row, from the lowest z.
  DirectionTable(std::vector<double> z_edges, int columns, std::vector<std::array<float, 3>> cells);

  /// Returns the interpolated radiance; outside of the range of z, the radiance of the nearest row.
  Rgb radiance(Vec3 direction) const;
  /// Returns a sample in proportion to the cells' luminance; pdf 0 if all cells are black.
  /// @param chance  Two uniform random numbers in [0, 1).
  DirectionSample sample(UnitPair chance) const;
  /// Returns the density of sample() in a direction, per steradian; 0 outside of the range of z.
  double pdf(Vec3 direction) const;
  /// Returns the sum of all cells' luminance times their solid angles.
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
