#include "compiler/map/plane/smooth_land.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "compiler/map/plane/bicubic.h"

namespace citykiln::map {
namespace {

constexpr int kMostParts = 4;

// Samples of SRTM lie 30 m or 90 m apart. Bends of 23 m show no facets in pictures, bends of 46 m do (ground.md).
constexpr double kLongestStep_m = 24;

using Sample = SmoothSample<double>;

// The samples of a row with their slopes, without the outermost.
std::vector<Sample> smooth_row(const Heightfield& samples, int j) {
  std::vector<Sample> row;
  for (int i = 1; i < samples.columns - 1; ++i)
    row.push_back(smooth_sample<double>([&](int c, int r) {
      return double{1} * samples.heights[static_cast<std::size_t>(j + r) * samples.columns + i + c];
    }));
  return row;
}

// Weights at the shares 0, 1 / parts, … below 1.
std::vector<HermiteWeights<double>> weights_of(int parts) {
  std::vector<HermiteWeights<double>> weights;
  for (int k = 0; k < parts; ++k) weights.push_back(hermite_weights(double{1} * k / parts));
  return weights;
}

std::int32_t rounded(double quanta) { return static_cast<std::int32_t>(std::floor(quanta + 0.5)); }

// Adds a row of heights at one share of the way from the southern row of samples to the northern one.
void add_row(const std::vector<Sample>& south, const std::vector<Sample>& north,
             const std::vector<HermiteWeights<double>>& weights, const HermiteWeights<double>& v,
             std::vector<std::int32_t>& heights) {
  for (std::size_t i = 0; i + 1 < south.size(); ++i) {
    const std::array<Sample, 4> corners{south[i], south[i + 1], north[i], north[i + 1]};
    for (const HermiteWeights<double>& u : weights) heights.push_back(rounded(patch_height(corners, u, v)));
  }
  const std::array<Sample, 4> last{south.back(), south.back(), north.back(), north.back()};
  heights.push_back(rounded(patch_height(last, weights.front(), v)));
}

}  // namespace

int smooth_parts(Vec2 step_m) {
  int parts = 1;
  while (parts < kMostParts && std::max(step_m.x, step_m.y) > parts * kLongestStep_m) parts *= 2;
  return parts;
}

Heightfield smooth_land(Heightfield samples, int parts) {
  assert(parts == 1 || parts == 2 || parts == 4);
  assert(samples.parts == 1);
  if (parts == 1) return samples;
  assert(samples.columns >= 4 && samples.rows >= 4);
  Heightfield land{.min = samples.vertex(1, 1),
                   .step_m = samples.step_m * (1.0 / parts),
                   .columns = (samples.columns - 3) * parts + 1,
                   .rows = (samples.rows - 3) * parts + 1,
                   .heights = {},
                   .resampling_error_m = samples.resampling_error_m};
  land.heights.reserve(static_cast<std::size_t>(land.columns) * land.rows);
  const std::vector<HermiteWeights<double>> weights = weights_of(parts);
  std::vector<Sample> south = smooth_row(samples, 1);
  for (int j = 2; j < samples.rows - 1; ++j) {
    std::vector<Sample> north = smooth_row(samples, j);
    for (const HermiteWeights<double>& v : weights) add_row(south, north, weights, v, land.heights);
    south = std::move(north);
  }
  add_row(south, south, weights, weights.front(), land.heights);
  land.parts = parts;
  land.samples = std::move(samples.heights);
  return land;
}

Heightfield samples_of(const Heightfield& field) {
  if (field.parts == 1) return field;
  const Vec2 step_m = field.sample_step_m();
  return {.min = field.min - step_m,
          .step_m = step_m,
          .columns = field.sample_columns(),
          .rows = field.sample_rows(),
          .heights = field.samples,
          .resampling_error_m = field.resampling_error_m};
}

}  // namespace citykiln::map
