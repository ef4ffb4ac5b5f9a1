// Fitted by tests/bench/fit_cost.py to tasks that tests/bench/measure_cost.py ran, 274 of 10 places (Monaco, Canillo,
// Chicago, Neubrandenburg, Berlin-Reinickendorf, St. Moritz, Kyoto, Liechtenstein, Los Angeles, Niteroi), regions of
// 512 and 1024 m, one thread, processor time. On 37 regions of other places (Andorra la Vella, Boston, Helsinki,
// Dublin, Nice, Berlin-Adlershof, Baltimore, Frederiksted), at all default levels, the median error of time is 16%, of
// memory 25%, of bytes 46%. The form of the model was chosen with these in view, so other places may be worse.
#include "compiler/commands/expected_cost.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace citykiln::commands {
namespace {

/// Weights of 1, and of a thousand way nodes and vertices of the heights, of a region with its halo.
using AroundWeights = std::array<double, 3>;
/// Weights of a thousand nodes of buildings, of roads, of other ways, and of nodes with tags, of a km2 and of a tile,
/// of the region itself; for memory, of a tile of its mean.
using OwnWeights = std::array<double, 6>;

struct LevelCost {
  double from_m;      ///< The row holds for tolerances from here to the next row's.
  double time_share;  ///< Of what all default levels take.
  OwnWeights memory_mb, output_mb;
};

// of all default levels
constexpr AroundWeights kAround_s = {0.164, 0.0142, 0.0002}, kAround_mb = {58.6, 1.2, 0.04};
constexpr OwnWeights kOwn_s = {0.904, 0.405, 2.44, 3.59, 0.576, 0};
/// The share of time that does not depend on the levels, such as planning and grading the terrain.
constexpr double kSharedTime = 0.234;
constexpr LevelCost kLevels[] = {{0, 0.263, {4.72, 0, 68.9, 0, 30.2, 0}, {4.29, 0, 12.4, 0, 0, 0}},
                                 {0.3, 0.158, {1.11, 0, 37.5, 0, 15.2, 0}, {1.95, 0, 4.68, 0, 0, 0}},
                                 {0.8, 0.160, {0, 0, 49, 0, 18.8, 0}, {0.931, 0, 3.04, 0, 0, 0}},
                                 {1.8, 0.130, {0, 0, 35.3, 0, 18, 0}, {0.482, 0, 1.56, 0, 0.0145, 0.0545}},
                                 {5, 0.055, {0.493, 0, 0, 6.69, 7.22, 0}, {0.031, 0.00894, 0.411, 0, 0.0534, 0.0864}}};

const LevelCost& cost_at(double tolerance_m) {
  const auto row = std::ranges::find_if(std::ranges::rbegin(kLevels), std::ranges::rend(kLevels),
                                        [&](const LevelCost& cost) { return cost.from_m <= tolerance_m; });
  return *row;
}

template <std::size_t N>
double weighted(const std::array<double, N>& weights, const std::array<double, N>& facts) {
  double sum = 0;
  for (std::size_t i = 0; i < N; ++i) sum += weights[i] * facts[i];
  return sum;
}

AroundWeights facts_around(const PlannedRegion& region) {
  return {1, static_cast<double>(region.file.way_nodes) * 1e-3, static_cast<double>(region.terrain_vertices) * 1e-3};
}

OwnWeights own_facts(const PlannedRegion& region, double tile_m) {
  const auto thousands = [](std::uint64_t count) { return static_cast<double>(count) * 1e-3; };
  const regions::RegionFile& file = region.file;
  const double tiles = static_cast<double>(region.tiles), buildings = thousands(file.own_building_nodes),
               roads = thousands(file.own_road_nodes);
  return {buildings,
          roads,
          std::max(0.0, thousands(file.own_way_nodes) - buildings - roads),
          thousands(file.own_nodes),
          tiles * tile_m * tile_m * 1e-6,
          tiles};
}

}  // namespace

ExpectedCost expected_cost(const PlannedRegion& region, double tile_m, std::span<const double> ladder_m) {
  const auto around = facts_around(region);
  const auto own = own_facts(region, tile_m);
  // tiles are baked one after the other; the fullest of n counts as n^0.5 of the mean
  OwnWeights of_a_tile = own;
  for (double& fact : of_a_tile) fact /= std::sqrt(std::max(1.0, own.back()));
  double time_share = kSharedTime, level_mb = 0, output_mb = 0;
  for (const double tolerance_m : ladder_m) {
    const LevelCost& cost = cost_at(tolerance_m);
    time_share += cost.time_share, output_mb += weighted(cost.output_mb, own);
    level_mb = std::max(level_mb, weighted(cost.memory_mb, of_a_tile));
  }
  const double seconds = (weighted(kAround_s, around) + weighted(kOwn_s, own)) * time_share,
               memory_mb = weighted(kAround_mb, around) + level_mb;
  return {seconds, static_cast<std::uint64_t>(memory_mb * 1e6), static_cast<std::uint64_t>(output_mb * 1e6)};
}

}  // namespace citykiln::commands
