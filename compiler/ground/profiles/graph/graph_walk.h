// Walks the profile graph from some nodes outwards, nearest first (Dijkstra 1959). A node is a station, a place along a
// road at which its height is decided; a leg is a directed edge between neighbouring stations; pinned nodes keep their
// heights.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "compiler/ground/profiles/graph/profile_graph.h"

namespace citykiln::ground {

/// Working memory for many walks over one graph, which must outlive it. A walk must not start another one, and the
/// object is not thread-safe.
class GraphWalk {
 public:
  explicit GraphWalk(const ProfileGraph& graph)
      : graph_(graph), cost_(graph.nodes.size(), std::numeric_limits<double>::infinity()) {}

  /// A start node and its initial cost.
  using Start = std::pair<double, std::uint32_t>;

  /// Calls reached(node, cost) once for each node that can be reached at a cost of at most `most`, in the order of
  /// costs, then of nodes. The walk continues beyond a node if reached() returns true.
  /// @param cost_of  The cost of a leg, >= 0.
  /// O(s log s) in the legs seen.
  template <typename CostOf, typename Reached>
  void from(std::span<const Start> starts, double most, CostOf cost_of, Reached reached) {
    for (const auto& [cost, node] : starts) improve(node, cost, most);
    while (!queue_.empty()) {
      std::ranges::pop_heap(queue_, std::greater<>());
      const auto [cost, node] = queue_.back();
      queue_.pop_back();
      if (cost > cost_[node] || !reached(node, cost)) continue;
      for (const Leg& leg : graph_.legs_of(node)) improve(leg.to, cost + cost_of(leg), most);
    }
    for (const std::uint32_t node : touched_) cost_[node] = std::numeric_limits<double>::infinity();
    touched_.clear();
  }

  /// Walks from one node at no cost.
  template <typename CostOf, typename Reached>
  void from(std::uint32_t node, double most, CostOf cost_of, Reached reached) {
    const Start start{0, node};
    from(std::span(&start, 1), most, cost_of, reached);
  }

 private:
  void improve(std::uint32_t node, double cost, double most) {
    if (cost >= cost_[node] || cost > most) return;
    cost_[node] = cost;
    touched_.push_back(node);
    queue_.emplace_back(cost, node);
    std::ranges::push_heap(queue_, std::greater<>());
  }

  const ProfileGraph& graph_;
  std::vector<double> cost_;
  std::vector<std::uint32_t> touched_;
  std::vector<Start> queue_;
};

/// Returns the nodes of the stations before and after a place along a way, as starts of cost 0.
///
/// @param way   Index into ProfileGraph::ways.
/// @param at_m  Distance along the way.
std::vector<GraphWalk::Start> starts_about(const ProfileGraph& graph, std::uint32_t way, double at_m);

}  // namespace citykiln::ground
