#include "compiler/ground/correction/corrected_land.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "compiler/contract/erase_repeated.h"
#include "compiler/ground/correction/heightmap_error.h"
#include "compiler/map/plane/smooth_land.h"

namespace citykiln::ground {
namespace {

// The length of line, in steps, that moves a sample by half of what is missing.
constexpr double kHalfMoved = 0.125;
// The greatest height of land above water beside it up to which roads may raise it.
constexpr double kBankOfWater_m = 3;
// Water decides the samples beside it more than a road that is as long.
constexpr double kWeightOfWater = 2;
// Samples of lines in a step.
constexpr double kLineSamples = 4;

// A place on a line: the four samples about it with their shares, and the change that the land needs there.
struct CorrectionPlace {
  std::array<std::uint32_t, 4> samples;  // numbers among the samples that move
  std::array<double, 4> shares;
  double wanted_m, weight;
  bool is_water;  // only undoes changes
};

struct PlaceOfLine {
  Vec2 at;
  double z_m, weight;
  KnownKind kind;
};

template <typename Each>
void for_each_place(std::span<const KnownLine> lines, double step_m, Each each) {
  for (const KnownLine& line : lines) {
    const double long_m = distance(line.from, line.to);
    const int count = std::max(1, static_cast<int>(std::ceil(long_m / step_m * kLineSamples)));
    for (int k = 0; k < count; ++k) {
      const double share = (k + 0.5) / count;
      each(PlaceOfLine{line.from + (line.to - line.from) * share, line.from_m + (line.to_m - line.from_m) * share,
                       long_m / count / step_m, line.kind});
    }
  }
}

double wanted_change_m(const map::Heightfield& heights, const PlaceOfLine& place) {
  const double missing_m = place.z_m - map::height_m_at(heights, place.at);
  if (place.kind != KnownKind::kRoad) return missing_m;
  const double error_m = heightmap_error_m(heights, place.at);
  return std::clamp(missing_m, -error_m, error_m);
}

// Places about samples, before the samples have numbers.
CorrectionPlace place_on(const map::Heightfield& samples, const map::Heightfield& heights, const PlaceOfLine& place) {
  const auto [i, j, u, v] = map::cell_at(samples, place.at);
  const auto south_west = static_cast<std::uint32_t>(j * samples.columns + i);
  const auto columns = static_cast<std::uint32_t>(samples.columns);
  return {{south_west, south_west + 1, south_west + columns, south_west + columns + 1},
          {(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v},
          wanted_change_m(heights, place),
          place.weight * (place.kind == KnownKind::kWater ? kWeightOfWater : 1),
          place.kind == KnownKind::kWater};
}

std::vector<CorrectionPlace> places_on(const map::Heightfield& samples, const map::Heightfield& heights,
                                       std::span<const KnownLine> lines) {
  std::vector<CorrectionPlace> places;
  const Box2 box = heights.box();
  for_each_place(lines, heights.shorter_sample_step_m(), [&](const PlaceOfLine& place) {
    if (box.contains(place.at)) places.push_back(place_on(samples, heights, place));
  });
  return places;
}

// Replaces the samples of places by their numbers in the sorted list of all of them, which is returned.
std::vector<std::uint32_t> number_samples(std::vector<CorrectionPlace>& places) {
  std::vector<std::uint32_t> moved;
  for (const CorrectionPlace& place : places) moved.insert(moved.end(), place.samples.begin(), place.samples.end());
  sort_unique(moved);
  for (CorrectionPlace& place : places)
    for (std::uint32_t& sample : place.samples)
      sample = static_cast<std::uint32_t>(std::ranges::lower_bound(moved, sample) - moved.begin());
  return moved;
}

double change_at(const CorrectionPlace& place, std::span<const double> change_m) {
  double sum_m = 0;
  for (std::size_t c = 0; c < 4; ++c) sum_m += place.shares[c] * change_m[place.samples[c]];
  return sum_m;
}

double missing_m(const CorrectionPlace& place, double change_m) {
  const double off_m = place.wanted_m - change_m;
  if (!place.is_water) return off_m;
  return off_m > 0 ? std::min(off_m, std::max(0.0, -change_m))
                   : std::max(std::min(off_m + kBankOfWater_m, 0.0), std::min(0.0, -change_m));
}

// The changes of samples that bring the land to the wanted heights.
std::vector<double> changes_of(std::span<const CorrectionPlace> places, std::size_t samples) {
  std::vector<double> weight(samples, kHalfMoved), change_m(samples), sum_m(samples);
  for (const CorrectionPlace& place : places)
    for (std::size_t c = 0; c < 4; ++c) weight[place.samples[c]] += place.weight * place.shares[c];
  for (int pass = 0; pass < kCorrectionPasses; ++pass) {
    std::ranges::fill(sum_m, 0.0);
    for (const CorrectionPlace& place : places) {
      const double off_m = missing_m(place, change_at(place, change_m)) * place.weight;
      for (std::size_t c = 0; c < 4; ++c) sum_m[place.samples[c]] += off_m * place.shares[c];
    }
    for (std::size_t s = 0; s < samples; ++s) change_m[s] += sum_m[s] / weight[s];
  }
  return change_m;
}

std::int32_t quanta_of(double height_m) {
  return static_cast<std::int32_t>(std::floor(height_m / map::kHeightQuantum_m + 0.5));
}

}  // namespace

map::Heightfield corrected_land(const map::Heightfield& heights, std::span<const KnownLine> lines) {
  if (lines.empty() || heights.longer_sample_step_m() <= kFineSamples_m) return heights;
  const int parts = heights.parts;
  map::Heightfield samples = map::samples_of(heights);
  std::vector<CorrectionPlace> places = places_on(samples, heights, lines);
  const std::vector<std::uint32_t> moved = number_samples(places);
  const std::vector<double> change_m = changes_of(places, moved.size());
  for (std::size_t s = 0; s < moved.size(); ++s) samples.heights[moved[s]] += quanta_of(change_m[s]);
  return map::smooth_land(std::move(samples), parts);
}

}  // namespace citykiln::ground
