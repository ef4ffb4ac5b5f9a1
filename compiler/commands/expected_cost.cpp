#include "compiler/commands/expected_cost.h"

#include <algorithm>

namespace citykiln::commands {
namespace {

/// Cost of one level, by its tolerance.
struct LevelCost {
  double from_m;  ///< The row holds for tolerances from here to the next row's.
  double ms_per_node, ms_per_tile, bytes_per_node, bytes_per_tile;
};

constexpr LevelCost kLevels[] = {{0, 0.6, 400, 1200, 400e3},
                                 {0.3, 0.2, 200, 400, 200e3},
                                 {1, 0.1, 150, 200, 150e3},
                                 {2, 0.08, 100, 120, 100e3},
                                 {8, 0.03, 60, 40, 50e3}};

constexpr double kStart_ms = 300, kPlan_ms_per_node = 0.02, kPlan_ms_per_vertex = 0.0002;
constexpr double kStart_bytes = 120e6, kBytes_per_node = 500, kBytes_per_vertex = 8, kBytes_per_own_node = 500;

const LevelCost& cost_at(double tolerance_m) {
  const auto row = std::ranges::find_if(std::ranges::rbegin(kLevels), std::ranges::rend(kLevels),
                                        [&](const LevelCost& cost) { return cost.from_m <= tolerance_m; });
  return *row;
}

}  // namespace

ExpectedCost expected_cost(const PlannedRegion& region, std::size_t vertices, std::span<const double> ladder_m) {
  const double nodes = static_cast<double>(region.file.way_nodes), own = static_cast<double>(region.file.own_way_nodes),
               tiles = static_cast<double>(region.tiles), grid = static_cast<double>(vertices);
  double ms = kStart_ms + kPlan_ms_per_node * nodes + kPlan_ms_per_vertex * grid, bytes = 0;
  for (const double tolerance_m : ladder_m) {
    const LevelCost& cost = cost_at(tolerance_m);
    ms += cost.ms_per_node * own + cost.ms_per_tile * tiles;
    bytes += cost.bytes_per_node * own + cost.bytes_per_tile * tiles;
  }
  const double memory = kStart_bytes + kBytes_per_node * nodes + kBytes_per_vertex * grid + kBytes_per_own_node * own;
  return {ms * 1e-3, static_cast<std::uint64_t>(memory), static_cast<std::uint64_t>(bytes)};
}

}  // namespace citykiln::commands
