#include "compiler/surroundings/grid_lines.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compiler/contract/erase_repeated.h"
#include "compiler/map/features.h"

namespace citykiln::surroundings {
namespace {

constexpr double kMostInside = 64, kStep_m = 16;

// Adds the multiples of a step between two places.
void add_multiples(double step_m, double low_m, double high_m, std::vector<std::int32_t>& lines) {
  for (double n = std::ceil(low_m / step_m); n * step_m <= high_m; ++n)
    lines.push_back(static_cast<std::int32_t>(n * step_m));
}

double step_inside(double width_m) {
  double step_m = map::kCell_m;
  while (width_m / step_m > kMostInside) step_m *= 2;
  return step_m;
}

}  // namespace

std::vector<std::int32_t> lines_for(double low_m, double high_m, double tile_m) {
  assert(low_m < high_m && tile_m >= map::kCell_m);
  std::vector<std::int32_t> lines = {static_cast<std::int32_t>(low_m), static_cast<std::int32_t>(high_m)};
  add_multiples(tile_m, low_m, high_m, lines);
  add_multiples(step_inside(high_m - low_m), low_m, high_m, lines);
  for (double away_m = 0; away_m < kReach_m;) {
    const double step_m = std::floor(away_m * kCellShare / kStep_m) * kStep_m;
    away_m = std::min(away_m + std::max<double>(kFinestCell_m, step_m), kReach_m);
    lines.push_back(static_cast<std::int32_t>(low_m - away_m));
    lines.push_back(static_cast<std::int32_t>(high_m + away_m));
  }
  sort_unique(lines);
  return lines;
}

}  // namespace citykiln::surroundings
