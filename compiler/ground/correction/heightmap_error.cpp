#include "compiler/ground/correction/heightmap_error.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace citykiln::ground {
namespace {

constexpr double kOfBend = 0.5, kOfRange = 0.25, kOfStep = 1.0 / 32, kMostNoise_m = 1;

// The samples about a place by their numbers from the cell's south-western one; samples at the field's border repeat.
struct SamplesAbout {
  const map::Heightfield& heights;
  int west, south;

  double at(int i, int j) const {
    const int column = west + i * heights.parts, row = south + j * heights.parts;
    return heights.height_m_at_vertex(std::clamp(column, 0, heights.columns - 1), std::clamp(row, 0, heights.rows - 1));
  }
  double bend(int i, int j) const {
    const double twice = 2 * at(i, j);
    return std::max(std::abs(at(i - 1, j) - twice + at(i + 1, j)), std::abs(at(i, j - 1) - twice + at(i, j + 1)));
  }
};

}  // namespace

double heightmap_error_m(const map::Heightfield& heights, Vec2 p) {
  const map::CellPosition cell = map::cell_at(heights, p);
  const SamplesAbout about{heights, cell.i / heights.parts * heights.parts, cell.j / heights.parts * heights.parts};
  const double bend_m = std::max({about.bend(0, 0), about.bend(1, 0), about.bend(0, 1), about.bend(1, 1)});
  const std::array<double, 4> corners{about.at(0, 0), about.at(1, 0), about.at(0, 1), about.at(1, 1)};
  const auto [low, high] = std::ranges::minmax(corners);
  return kOfBend * bend_m + kOfRange * (high - low) + std::min(kMostNoise_m, kOfStep * heights.longer_sample_step_m());
}

}  // namespace citykiln::ground
