#include "preview/surface/reflected_energy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "preview/surface/microfacet.h"

namespace citykiln::preview {
namespace {

// Rows by the square root of alpha, columns by the square root of the cosine: both change fastest near 0.
constexpr int kAlphaRows = 32, kCosineColumns = 48, kSide = 24;
constexpr double kLeastAlphaRow = 0.1, kLeastTableCosine = 1e-4;

double alpha_of(double row) {
  const double root = kLeastAlphaRow + (1 - kLeastAlphaRow) * row / (kAlphaRows - 1);
  return root * root;
}
double cosine_of(double column) {
  const double root = column / (kCosineColumns - 1);
  return std::max(kLeastTableCosine, root * root);
}

// The mean over sampled facets of what each reflects, divided by their density.
SingleReflection integrated(double alpha, double cosine) {
  const Microfacets facets{alpha};
  const Vec3 eye{std::sqrt(1 - cosine * cosine), 0, cosine};
  SingleReflection sum{0, 0};
  for (int i = 0; i < kSide; ++i)
    for (int j = 0; j < kSide; ++j) {
      const Vec3 facet = facets.sample(eye, {(i + 0.5) / kSide, (j + 0.5) / kSide});
      const Vec3 out = mirrored(eye, facet);
      if (out.z <= 0) continue;
      const double through = facets.seen(eye, out) / facets.seen(eye), c = 1 - std::max(0.0, dot(eye, facet));
      const double grazing = c * c * c * c * c;
      sum.mirror += through * (1 - grazing), sum.grazing += through * grazing;
    }
  return {sum.mirror / (kSide * kSide), sum.grazing / (kSide * kSide)};
}

struct Table {
  std::array<std::array<SingleReflection, kCosineColumns>, kAlphaRows> cells;
  std::array<SingleReflection, kAlphaRows> means;

  Table() {
    for (int row = 0; row < kAlphaRows; ++row) {
      for (int column = 0; column < kCosineColumns; ++column)
        cells[row][column] = integrated(alpha_of(row), cosine_of(column));
      means[row] = mean_of(cells[row]);
    }
  }

  // The integral of 2 cos over the cosine, which is 4 t³ over t = √cos; the trapezoidal rule.
  static SingleReflection mean_of(const std::array<SingleReflection, kCosineColumns>& row) {
    SingleReflection sum{0, 0};
    double weights = 0;
    for (int column = 0; column < kCosineColumns; ++column) {
      const double t = static_cast<double>(column) / (kCosineColumns - 1);
      const double weight = t * t * t * (column == kCosineColumns - 1 ? 0.5 : 1);
      sum.mirror += weight * row[column].mirror, sum.grazing += weight * row[column].grazing, weights += weight;
    }
    return {sum.mirror / weights, sum.grazing / weights};
  }
};

const Table& reflection_table() {
  static const Table all;
  return all;
}

SingleReflection reflection_between(const SingleReflection& a, const SingleReflection& b, double share) {
  return {a.mirror + (b.mirror - a.mirror) * share, a.grazing + (b.grazing - a.grazing) * share};
}

// A place in a table: the entry before it, and the share of the next.
struct Place {
  int before;
  double share;
};

Place place_of(double at, int count) {
  const double clamped = std::clamp(at, 0.0, count - 1.0);
  const int before = std::min(static_cast<int>(clamped), count - 2);
  return {before, clamped - before};
}

}  // namespace

SingleReflections::SingleReflections(double alpha) {
  const Place place = place_of(
      (std::sqrt(std::max(0.0, alpha)) - kLeastAlphaRow) / (1 - kLeastAlphaRow) * (kAlphaRows - 1), kAlphaRows);
  row_ = place.before, share_ = place.share;
}

SingleReflection SingleReflections::at(double cosine) const {
  const Place column = place_of(std::sqrt(std::max(0.0, cosine)) * (kCosineColumns - 1), kCosineColumns);
  const auto along = [&](const std::array<SingleReflection, kCosineColumns>& row) {
    return reflection_between(row[column.before], row[column.before + 1], column.share);
  };
  const Table& all = reflection_table();
  return reflection_between(along(all.cells[row_]), along(all.cells[row_ + 1]), share_);
}

SingleReflection SingleReflections::mean() const {
  return reflection_between(reflection_table().means[row_], reflection_table().means[row_ + 1], share_);
}

}  // namespace citykiln::preview
