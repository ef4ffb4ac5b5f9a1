// Fitted by tests/bench/fit_cost.py to 474 tasks that tests/bench/measure_cost.py ran, of 10 places (Monaco, Canillo,
// Chicago, Neubrandenburg, Berlin-Reinickendorf, St. Moritz, Kyoto, Liechtenstein, Los Angeles, Niteroi), regions of
// 512 to 2048 m, one thread, processor time. On 59 regions of other places (Andorra la Vella, Boston, Helsinki,
// Dublin, Nice, Berlin-Adlershof, Baltimore, Frederiksted), at all default levels, the median error of time is 28%, of
// memory 17%, of bytes 35%; none of these tasks took more than twice the expected memory, 9 of the fitted ones did. Six
// regions of 5 km with woods, of copies of Andorra without heights, took 0.5 to 1.4 times the expected memory, 0.7
// to 1.7 times the time, and 1.6 to 4.5 times the bytes. The form of the model was chosen with all of these in view, so
// other places may be worse.
#include "compiler/commands/plan/expected_cost.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace citykiln::commands {
namespace {

/// Weights of a constant, of a thousand way nodes and of a thousand vertices of the heights, of a region with its halo.
using AroundWeights = std::array<double, 3>;
/// Weights of the contents of the region itself: a thousand nodes of buildings, of roads, of other ways, nodes with
/// tags, trees and plantings; a km2; a tile; the presence of trees, and of buildings. For memory, the contents are
/// those of a tile.
using OwnWeights = std::array<double, 10>;

struct LevelCost {
  double from_m;      ///< The row is used for tolerances from here to the next row's.
  double time_share;  ///< The share of the time of all default levels.
  OwnWeights memory_mb, output_mb;
};

// of all default levels
constexpr AroundWeights kAround_s = {0.576, 0.0193, 0.0002}, kAround_mb = {50.1, 1.2, 0.04};
constexpr OwnWeights kOwn_s = {0.718, 0.659, 0, 1.51, 0.279, 0.000242, 0, 0.00405, 0.917, 1.21};
/// The share of time that does not depend on the levels, such as planning and grading the terrain.
constexpr double kSharedTime = 0.305;
/// The share of their memory that levels other than the largest add.
constexpr double kOtherLevels = 0.5;
constexpr LevelCost kLevels[] = {
    {0, 0.199, {3.44, 15.1, 0, 0, 25.5, 0, 6.91, 0, 9.4, 29.7}, {3.37, 0.924, 2.08, 6.62, 3.62, 0, 0, 0, 0, 2.87}},
    {0.3, 0.124, {5.81, 4.06, 0, 0, 25.7, 0, 9.88, 0, 0, 9.78}, {1.88, 0.299, 1.05, 0.332, 1.73, 0, 0, 0, 0, 0.945}},
    {0.8,
     0.195,
     {0, 2.67, 0, 35.7, 20.8, 0, 11, 0, 37.6, 6.39},
     {1.36, 0.179, 0.645, 0.25, 1.52, 0, 0, 0.0214, 0, 0.161}},
    {1.8,
     0.155,
     {0, 0, 0, 32.9, 15.5, 0, 10.3, 0, 38.1, 3.98},
     {0.712, 0.136, 0.309, 0.0275, 0.866, 0, 0, 0.0348, 0, 0.116}},
    {5,
     0.022,
     {0, 0, 0, 0, 2.23, 0.00361, 6.34, 0, 5.88, 1.22},
     {0.127, 0.22, 0, 0.332, 0.105, 0, 0.0067, 0.0189, 0.0671, 0.0711}}};

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

/// Grows from 0 for none to 1, since few trees need as many materials and prototypes as many trees do.
double presence(double thousands, double scale) { return 1 - std::exp(-thousands / scale); }

/// Returns a share of the counts of the region itself, and a share of its plants.
OwnWeights own_facts(const PlannedRegion& region, double tile_m, double share, double share_of_plants) {
  const auto thousands = [&](std::uint64_t count) { return share * static_cast<double>(count) * 1e-3; };
  const auto thousand_plants = [&](std::uint64_t count) { return share_of_plants * static_cast<double>(count) * 1e-3; };
  const regions::RegionFile& file = region.file;
  const double tiles = share * static_cast<double>(region.tiles), buildings = thousands(file.own_building_nodes),
               roads = thousands(file.own_road_nodes), trees = thousand_plants(file.own_trees);
  return {buildings,
          roads,
          std::max(0.0, thousands(file.own_way_nodes) - buildings - roads),
          thousands(file.own_nodes),
          trees,
          thousand_plants(file.own_plantings),
          tiles * tile_m * tile_m * 1e-6,
          tiles,
          presence(trees, 0.05),
          presence(buildings, 0.2)};
}

}  // namespace

ExpectedCost expected_cost(const PlannedRegion& region, double tile_m, std::span<const double> tolerances_m) {
  const auto around = facts_around(region);
  const auto own = own_facts(region, tile_m, 1, 1);
  // tiles are baked one after the other; the fullest of n counts as n^0.5 of the mean, but woods fill tiles evenly
  const double tiles = std::max<double>(1, region.tiles);
  const auto of_a_tile = own_facts(region, tile_m, 1 / std::sqrt(tiles), 1 / tiles);
  double time_share = kSharedTime, most_mb = 0, sum_mb = 0, output_mb = 0;
  for (const double tolerance_m : tolerances_m) {
    const LevelCost& cost = cost_at(tolerance_m);
    const double level_mb = weighted(cost.memory_mb, of_a_tile);
    time_share += cost.time_share, output_mb += weighted(cost.output_mb, own);
    most_mb = std::max(most_mb, level_mb), sum_mb += level_mb;
  }
  const double level_mb = most_mb + kOtherLevels * (sum_mb - most_mb);
  const double seconds = (weighted(kAround_s, around) + weighted(kOwn_s, own)) * time_share,
               memory_mb = weighted(kAround_mb, around) + level_mb;
  return {seconds, static_cast<std::uint64_t>(memory_mb * 1e6), static_cast<std::uint64_t>(output_mb * 1e6)};
}

}  // namespace citykiln::commands
