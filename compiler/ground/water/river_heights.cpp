#include "compiler/ground/water/river_heights.h"

#include <algorithm>
#include <limits>

#include "compiler/ground/water/descending_fit.h"
#include "compiler/ground/water/strong_components.h"

namespace citykiln::ground {
namespace {

// Steps between stops are half the heightfield's: four of its steps are smoothed over.
constexpr int kRounds = 32;

using Neighbours = std::vector<std::vector<std::uint32_t>>;

Neighbours downstream_of(const RiverNetwork& network) {
  Neighbours downstream(network.nodes.size());
  for (const RiverLine& line : network.lines)
    for (std::size_t i = 0; i + 1 < line.stops.size(); ++i) {
      const std::uint32_t from = line.stops[i].node, to = line.stops[i + 1].node;
      if (from != to) downstream[from].push_back(to);
    }
  return downstream;
}

// The network with its circles drawn together.
struct Falls {
  Components components;
  FlowGraph flow;
  std::vector<bool> stays;     // standing water and circles
  std::vector<double> land_m;  // by component: that of its only node, or infinity
};

void sort_out(std::vector<std::uint32_t>& neighbours) {
  std::sort(neighbours.begin(), neighbours.end());
  neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
}

Falls draw_together(const RiverNetwork& network, const std::vector<bool>& seas) {
  const Neighbours downstream = downstream_of(network);
  Falls falls{strong_components(downstream), {}, {}, {}};
  const std::uint32_t count = falls.components.count;
  falls.flow = {std::vector<std::vector<WeightedHeight>>(count), Neighbours(count), std::vector<bool>(count)};
  falls.stays.assign(count, false);
  falls.land_m.assign(count, std::numeric_limits<double>::infinity());
  for (std::uint32_t i = 0; i < network.nodes.size(); ++i) {
    const std::uint32_t c = falls.components.of[i];
    const RiverNode& node = network.nodes[i];
    falls.stays[c] = falls.stays[c] || network.is_water(i) || !falls.flow.pulls[c].empty();
    falls.flow.pulls[c].push_back({node.land_m, node.weight_mm, node.weight_mm * kAboveCost});
    if (network.is_water(i) && seas[i]) falls.flow.is_sea[c] = true;
    if (node.is_known()) falls.land_m[c] = std::min(falls.land_m[c], node.land_m);
    for (const std::uint32_t d : downstream[i])
      if (falls.components.of[d] != c) falls.flow.downstream[c].push_back(falls.components.of[d]);
  }
  for (auto& neighbours : falls.flow.downstream) sort_out(neighbours);
  return falls;
}

// Of each node the lowest land upstream of it, its own included.
std::vector<double> lowest_lands(const Falls& falls) {
  std::vector<double> lowest = falls.land_m;
  for (std::size_t i = lowest.size(); i-- > 0;)
    for (const std::uint32_t d : falls.flow.downstream[i]) lowest[d] = std::min(lowest[d], lowest[i]);
  return lowest;
}

Neighbours upstream_of(const Neighbours& downstream) {
  Neighbours upstream(downstream.size());
  for (std::uint32_t i = 0; i < downstream.size(); ++i)
    for (const std::uint32_t d : downstream[i]) upstream[d].push_back(i);
  return upstream;
}

// u above v: u' >= 3/4 u + 1/4 v, v' <= 3/4 v + 1/4 u, so u' - v' >= (u - v) / 2. Bounds fall downstream themselves.
std::vector<double> smoothed(const Falls& falls, std::vector<double> heights) {
  const Neighbours &downstream = falls.flow.downstream, upstream = upstream_of(downstream);
  std::vector<double> lowest = heights, highest = lowest_lands(falls), next = heights;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    lowest[i] -= kMaxSmoothing_m;
    highest[i] = std::max(highest[i], heights[i]);
  }
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t i = 0; i < heights.size(); ++i) {
      // springs and ends stay too, or they would be drawn level
      if (falls.stays[i] || upstream[i].empty() || downstream[i].empty()) continue;
      double before = std::numeric_limits<double>::infinity(), after = -before;
      for (const std::uint32_t u : upstream[i]) before = std::min(before, heights[u]);
      for (const std::uint32_t d : downstream[i]) after = std::max(after, heights[d]);
      next[i] = std::clamp(heights[i] / 2 + before / 4 + after / 4, lowest[i], highest[i]);
    }
    std::swap(heights, next);
  }
  return heights;
}

}  // namespace

RiverHeights find_river_heights(const RiverNetwork& network, const std::vector<bool>& seas) {
  const Falls falls = draw_together(network, seas);
  const std::vector<double> heights = smoothed(falls, fit_descending(falls.flow));
  RiverHeights found;
  std::vector<bool> has_water(falls.components.count);
  for (std::uint32_t w = 0; w < network.water_count; ++w) has_water[falls.components.of[w]] = true;
  for (const std::uint32_t c : falls.components.of) {
    found.height_m.push_back(heights[c]);
    found.is_cycle.push_back(falls.stays[c] && !has_water[c]);
  }
  return found;
}

}  // namespace citykiln::ground
