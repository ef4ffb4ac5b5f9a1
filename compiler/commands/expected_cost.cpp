// Fitted by tests/bench/fit_cost.py to tasks that tests/bench/measure_cost.py ran, 98 of 7 places (Monaco, Canillo,
// Chicago, Neubrandenburg, Berlin-Reinickendorf, St. Moritz, Kyoto, Liechtenstein, Los Angeles, Niteroi), regions of
// 512 and 1024 m, one thread, processor time. On 13 regions of other places (Andorra la Vella, Boston, Helsinki,
// Dublin, Nice, Berlin-Adlershof, Baltimore, Frederiksted), at all default levels, the median error of time is 26%, of
// memory 20%, of bytes 46%.
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

constexpr AroundWeights kPlan_s = {0, 0.0167, 0}, kPlan_mb = {49.5, 0.167, 18.3};
constexpr OwnWeights kShared_s = {0.255, 0, 0.657, 0.376, 0, 0};
constexpr LevelCost kLevels[] = {
    {0, {0, 0.305, 0.217, 2.59, 0.236, 0}, {13, 0, 52.5, 194, 12.8, 10.1}, {5.52, 0, 4.15, 23.2, 0, 0}},
    {0.3, {0.135, 0.0745, 1.41, 0.157, 0, 0}, {9.2, 0, 93.9, 32.7, 0, 1.09}, {2.51, 0, 2.05, 4.64, 0, 0}},
    {0.8, {0.076, 0.0459, 1.42, 0.84, 0, 0}, {5.42, 0, 119, 78.1, 0, 0}, {1.29, 0, 1.42, 2.41, 0, 0.033}},
    {1.8, {0.0117, 0.117, 1.25, 0.662, 0, 0}, {3.36, 0, 99, 104, 0, 2.03}, {0.713, 0, 0.816, 0.555, 0, 0.0699}},
    {5,
     {0.12, 0.129, 0.533, 0, 0.00901, 0.0247},
     {11.5, 0, 29.1, 42.2, 0, 5.62},
     {0.0873, 0, 0.357, 0.271, 0.0377, 0.062}}};

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
