#include "compiler/sky/atmosphere/columns.h"

#include <algorithm>
#include <cmath>

namespace citykiln::sky {
namespace {

constexpr int kColumnHeights = 64, kColumnDirections = 96, kColumnSteps = 64;

Columns integral(const Air& air, double height_m, double cos_zenith) {
  const double r = kEarth_m + height_m;
  // rays below the horizon by rounding must not stop at the ground
  const double end_m =
      -r * cos_zenith +
      std::sqrt(std::max(0.0, r * r * (cos_zenith * cos_zenith - 1) + (kEarth_m + kTop_m) * (kEarth_m + kTop_m)));
  double sums[3] = {};
  for (int i = 0; i < kColumnSteps; ++i) {
    const double from = static_cast<double>(i) / kColumnSteps, to = static_cast<double>(i + 1) / kColumnSteps;
    const double from_m = from * from * end_m, step_m = to * to * end_m - from_m, at_m = from_m + step_m / 2;
    const double there_m = std::sqrt(r * r + at_m * at_m + 2 * r * at_m * cos_zenith) - kEarth_m;
    const Densities density = densities_at(air, there_m);
    sums[0] += density.molecules * step_m, sums[1] += density.aerosols * step_m, sums[2] += density.ozone * step_m;
  }
  return {static_cast<float>(sums[0]), static_cast<float>(sums[1]), static_cast<float>(sums[2])};
}

float mixed_amount(float a, float b, float share) { return a + (b - a) * share; }
Columns mixed_columns(const Columns& a, const Columns& b, float share) {
  return {mixed_amount(a.molecules, b.molecules, share), mixed_amount(a.aerosols, b.aerosols, share),
          mixed_amount(a.ozone, b.ozone, share)};
}

}  // namespace

double horizon_cosine(double height_m) {
  const double share = kEarth_m / (kEarth_m + std::max(height_m, 0.0));
  return -std::sqrt(std::max(0.0, 1 - share * share));
}

double disk_share(double height_m, double cos_zenith) {
  // near the horizon cosines differ as angles do
  const double share = std::clamp(((cos_zenith - horizon_cosine(height_m)) / kSunRadius_rad + 1) / 2, 0.0, 1.0);
  return share * share * (3 - 2 * share);
}

double way_m(double height_m, double cos_zenith) {
  const double r = kEarth_m + height_m;
  const double flat = r * r * (cos_zenith * cos_zenith - 1);
  if (cos_zenith < horizon_cosine(height_m))
    return -r * cos_zenith - std::sqrt(std::max(0.0, flat + kEarth_m * kEarth_m));
  return -r * cos_zenith + std::sqrt(std::max(0.0, flat + (kEarth_m + kTop_m) * (kEarth_m + kTop_m)));
}

ColumnTable::ColumnTable(const Air& air) {
  for (int i = 0; i < kColumnHeights; ++i) {
    const double root = static_cast<double>(i) / (kColumnHeights - 1), height_m = root * root * kTop_m;
    const double horizon = horizon_cosine(height_m);
    for (int j = 0; j < kColumnDirections; ++j) {
      const double up = static_cast<double>(j) / (kColumnDirections - 1);
      cells_.push_back(integral(air, height_m, horizon + up * up * (1 - horizon)));
    }
  }
}

Columns ColumnTable::at(double height_m, double cos_zenith) const {
  const double horizon = horizon_cosine(height_m);
  const double up = std::sqrt(std::clamp((cos_zenith - horizon) / (1 - horizon), 0.0, 1.0)) * (kColumnDirections - 1);
  const double high = std::sqrt(std::clamp(height_m / kTop_m, 0.0, 1.0)) * (kColumnHeights - 1);
  const int i = std::min(static_cast<int>(high), kColumnHeights - 2),
            j = std::min(static_cast<int>(up), kColumnDirections - 2);
  const Columns* cell = &cells_[static_cast<std::size_t>(i) * kColumnDirections + j];
  const auto across = static_cast<float>(up - j);
  return mixed_columns(mixed_columns(cell[0], cell[1], across),
                       mixed_columns(cell[kColumnDirections], cell[kColumnDirections + 1], across),
                       static_cast<float>(high - i));
}

}  // namespace citykiln::sky
