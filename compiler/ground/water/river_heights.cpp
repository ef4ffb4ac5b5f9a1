#include "compiler/ground/water/river_heights.h"

#include <algorithm>
// vector_as_graph.hpp makes a vector of vectors a graph and must come first
// clang-format off
#include <boost/graph/vector_as_graph.hpp>
#include <boost/graph/strong_components.hpp>
// clang-format on
#include <cassert>
#include <limits>

#include "compiler/contract/erase_repeated.h"
#include "compiler/ground/water/descending_fit.h"

namespace citykiln::ground {
namespace {

// Rounds of smoothing: stations are half a grid step apart, so about four grid steps are smoothed over.
constexpr int kSmoothingRounds = 32;

using Neighbours = std::vector<std::vector<std::uint32_t>>;

Neighbours downstream_of(const RiverNetwork& network, const std::vector<bool>& apart) {
  Neighbours downstream(network.nodes.size());
  for (std::size_t l = 0; l < network.lines.size(); ++l) {
    const std::vector<RiverStation>& stops = network.lines[l].stops;
    for (std::size_t i = 0; !apart[l] && i + 1 < stops.size(); ++i)
      if (stops[i].node != stops[i + 1].node) downstream[stops[i].node].push_back(stops[i + 1].node);
  }
  return downstream;
}

// The heights that a node should have: that of the land, and not below the lowest land across the line.
void add_given(const RiverNode& node, std::vector<WeightedHeight>& given) {
  given.push_back({node.land_m, node.weight_mm, node.weight_mm * kAboveCost});
  if (node.low_m < node.land_m) given.push_back({node.low_m, node.weight_mm, 1});
}

// The strongly connected component of each node, numbered so that every edge leads to its own component or to one with
// a lower number (Tarjan 1972, as Boost has it).
struct Components {
  std::vector<std::uint32_t> of;
  std::uint32_t count = 0;
};

Components strong_components(const Neighbours& successors) {
  Components components{std::vector<std::uint32_t>(successors.size()), 0};
  components.count = static_cast<std::uint32_t>(boost::strong_components(
      successors, boost::make_iterator_property_map(components.of.begin(), boost::identity_property_map()),
      boost::vertex_index_map(boost::identity_property_map())));
  return components;
}

// The network with each cycle contracted to one node.
struct ContractedNetwork {
  Components components;
  FlowGraph flow;
  std::vector<bool> stays;     // standing water and cycles
  std::vector<double> land_m;  // per component: its node's terrain, or infinity if it says nothing
};

ContractedNetwork contract_cycles(const RiverNetwork& network, const std::vector<bool>& seas,
                                  const std::vector<bool>& apart) {
  const Neighbours downstream = downstream_of(network, apart);
  ContractedNetwork contracted{strong_components(downstream), {}, {}, {}};
  const std::uint32_t count = contracted.components.count;
  contracted.flow = {std::vector<std::vector<WeightedHeight>>(count), Neighbours(count), std::vector<bool>(count)};
  contracted.stays.assign(count, false);
  contracted.land_m.assign(count, std::numeric_limits<double>::infinity());
  for (std::uint32_t i = 0; i < network.nodes.size(); ++i) {
    const std::uint32_t c = contracted.components.of[i];
    const RiverNode& node = network.nodes[i];
    contracted.stays[c] = contracted.stays[c] || network.is_water(i) || !contracted.flow.given[c].empty();
    add_given(node, contracted.flow.given[c]);
    if (network.is_water(i) && seas[i]) contracted.flow.is_sea[c] = true;
    if (node.is_known()) contracted.land_m[c] = std::min(contracted.land_m[c], node.land_m);
    for (const std::uint32_t d : downstream[i])
      if (contracted.components.of[d] != c) contracted.flow.downstream[c].push_back(contracted.components.of[d]);
  }
  for (auto& neighbours : contracted.flow.downstream) sort_unique(neighbours);
  return contracted;
}

// Returns per node the lowest terrain upstream of it and at it.
std::vector<double> lowest_lands(const ContractedNetwork& contracted) {
  std::vector<double> lowest = contracted.land_m;
  for (std::size_t i = lowest.size(); i-- > 0;)
    for (const std::uint32_t d : contracted.flow.downstream[i]) lowest[d] = std::min(lowest[d], lowest[i]);
  return lowest;
}

Neighbours upstream_of(const Neighbours& downstream) {
  Neighbours upstream(downstream.size());
  for (std::uint32_t i = 0; i < downstream.size(); ++i)
    for (const std::uint32_t d : downstream[i]) upstream[d].push_back(i);
  return upstream;
}

// Heights stay descending: for u upstream of v, u' >= 3/4 u + 1/4 v and v' <= 3/4 v + 1/4 u, so u' - v' >= (u - v) / 2
// >= 0; the bounds descend as well.
std::vector<double> smoothed(const ContractedNetwork& contracted, std::vector<double> heights) {
  const Neighbours &downstream = contracted.flow.downstream, upstream = upstream_of(downstream);
  std::vector<double> lowest = heights, highest = lowest_lands(contracted), next = heights;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    lowest[i] -= kMaxSmoothing_m;
    highest[i] = std::max(std::min(highest[i], heights[i] + kMaxSmoothingLift_m), heights[i]);
  }
  for (int round = 0; round < kSmoothingRounds; ++round) {
    for (std::size_t i = 0; i < heights.size(); ++i) {
      // springs and ends stay, else repeated rounds would make the river level
      if (contracted.stays[i] || upstream[i].empty() || downstream[i].empty()) continue;
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

RiverHeights find_river_heights(const RiverNetwork& network, const std::vector<bool>& seas,
                                const std::vector<bool>& apart) {
  assert(seas.size() == network.water_count && apart.size() == network.lines.size());
  const ContractedNetwork contracted = contract_cycles(network, seas, apart);
  const std::vector<double> heights = smoothed(contracted, fit_descending(contracted.flow));
  RiverHeights found;
  std::vector<bool> has_water(contracted.components.count);
  for (std::uint32_t w = 0; w < network.water_count; ++w) has_water[contracted.components.of[w]] = true;
  for (const std::uint32_t c : contracted.components.of) {
    found.height_m.push_back(heights[c]);
    found.is_cycle.push_back(contracted.stays[c] && !has_water[c]);
  }
  return found;
}

std::vector<double> heights_alone(const RiverNetwork& network, const RiverLine& line, const std::vector<bool>& seas) {
  FlowGraph flow;
  for (std::uint32_t i = 0; i < line.stops.size(); ++i) {
    const std::uint32_t node = line.stops[line.stops.size() - 1 - i].node;
    add_given(network.nodes[node], flow.given.emplace_back());
    flow.downstream.emplace_back();
    if (i > 0) flow.downstream.back().push_back(i - 1);
    flow.is_sea.push_back(network.is_water(node) && seas[node]);
  }
  std::vector<double> heights = fit_descending(flow);
  std::ranges::reverse(heights);
  return heights;
}

}  // namespace citykiln::ground
