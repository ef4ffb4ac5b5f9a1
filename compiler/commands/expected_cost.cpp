// Fitted by tests/bench/fit_cost.py to tasks that tests/bench/measure_cost.py ran, 103 of 7 places (Monaco, Canillo,
// Chicago, Neubrandenburg, Berlin-Reinickendorf, St. Moritz, Kyoto, Liechtenstein, Los Angeles, Niteroi), regions of
// 512 and 1024 m, one thread, processor time. On 16 regions of other places (Andorra la Vella, Boston, Helsinki,
// Dublin, Nice, Berlin-Adlershof, Baltimore, Frederiksted), at all default levels, the median error of time is 27%, of
// memory 15%, of bytes 37%.
#include "compiler/commands/expected_cost.h"

#include <algorithm>
#include <array>

namespace citykiln::commands {
namespace {

/// Weights of 1, and of a thousand way nodes and vertices of the heights, of a region with its halo.
using AroundWeights = std::array<double, 3>;
/// Weights of a thousand nodes of buildings, of roads, of other ways, and of nodes with tags, of a km2 and of a tile,
/// of the region itself.
using OwnWeights = std::array<double, 6>;

struct LevelCost {
  double from_m;  ///< The row holds for tolerances from here to the next row's.
  OwnWeights seconds, memory_mb, output_mb;
};

constexpr AroundWeights kPlan_s = {0, 0.0167, 0.0002}, kPlan_mb = {58, 0.0994, 0.04};
constexpr OwnWeights kShared_s = {0.23, 0, 0.684, 0.121, 0, 0};
constexpr LevelCost kLevels[] = {
    {0, {0, 0.332, 0.364, 2.59, 0.208, 0}, {8.81, 0, 71.1, 195, 19.3, 4.08}, {5.52, 0, 4.22, 24.2, 0, 0}},
    {0.3, {0.159, 0.0778, 1.38, 0.451, 0, 0}, {7.54, 0, 95.2, 31.6, 0, 2.59}, {2.51, 0, 2.05, 4.88, 0, 0}},
    {0.8, {0.101, 0.049, 1.39, 1.14, 0, 0}, {4, 0, 117, 82.4, 2.01, 0}, {1.28, 0, 1.43, 2.5, 0, 0.0317}},
    {1.8, {0.0363, 0.12, 1.21, 0.985, 0, 0}, {1.82, 0, 101, 79.4, 0.111, 3.54}, {0.712, 0, 0.818, 0.596, 0, 0.0693}},
    {5,
     {0.159, 0.15, 0.673, 0, 0, 0.0111},
     {4.98, 0, 39.7, 18.1, 0.352, 7.43},
     {0.0804, 0, 0.449, 0.191, 0.0285, 0.0604}}};

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
  double seconds = weighted(kPlan_s, around) + weighted(kShared_s, own), level_mb = 0, output_mb = 0;
  for (const double tolerance_m : ladder_m) {
    const LevelCost& cost = cost_at(tolerance_m);
    seconds += weighted(cost.seconds, own), output_mb += weighted(cost.output_mb, own);
    level_mb = std::max(level_mb, weighted(cost.memory_mb, own));
  }
  const double memory_mb = weighted(kPlan_mb, around) + level_mb;
  return {seconds, static_cast<std::uint64_t>(memory_mb * 1e6), static_cast<std::uint64_t>(output_mb * 1e6)};
}

}  // namespace citykiln::commands
