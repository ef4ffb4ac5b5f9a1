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

#include "compiler/ground/profiles/profile_graph.h"

namespace citykiln::ground {

/// Working memory for many walks over one graph.
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

/// Returns the stations before and after a place along a way, as starts of cost 0.
/// @param at_m  Distance along the way.
std::vector<GraphWalk::Start> starts_about(const ProfileGraph& graph, std::uint32_t way, double at_m);

/// Returns for each node true if a road or rail goes through it. Paths are planned after roads and rails and must not
/// move these nodes.
std::vector<bool> nodes_of_graded(const ProfileGraph& graph);

/// Returns the grade limit of a leg: the largest rise over run.
double limit_of(const ProfileGraph& graph, const Leg& leg);

/// True for ways that may exceed their limit for a clearance: streets and paths, not rails, motorways and runways.
bool may_be_steeper(const ProfileGraph& graph, std::uint32_t way);

/// A pinned node limits heights of other nodes up to this height above its own.
inline constexpr double kPinRadius_m = 64;

/// Returns for each node the greatest height that the grade limits allow from the pinned nodes near it; infinity if
/// none is near.
/// @param z_m  Heights by node.
std::vector<double> caps_near_pinned(const ProfileGraph& graph, GraphWalk& walk, std::span<const double> z_m);

/// The largest depth below its terrain to which a line on the ground may be lowered, as under a railway, with slopes on
/// both sides.
inline constexpr double kMaxCutting_m = 8;
/// The largest lowering of a street on the ground for the sake of an access road, such as the ramp of a garage.
inline constexpr double kMaxCuttingForAccess_m = 2.5;

/// True for service roads, farm tracks and unpaved roads. Streets are hardly lowered for them (kMaxCuttingForAccess_m).
bool is_access_road(map::LandCoverClass surface);

/// The lowest allowed heights by node, with changed sign.
struct LoweringCaps {
  std::vector<double> of_access, of_others;  ///< For lowering with an access road, and with any other line.
};

/// Returns the lowest allowed heights. Lines on the ground may be kMaxCutting_m below `ground_m`; streets that are
/// lowered with an access road kMaxCuttingForAccess_m. Tunnels, and access roads connected to such streets, may go
/// lower at their grade limits. Near pinned nodes grade limits apply, too. Radius of influence: kPinRadius_m of height.
/// @param ground_m  Heights by node before any lowering.
LoweringCaps lowering_caps(const ProfileGraph& graph, GraphWalk& walk, std::span<const double> ground_m);

}  // namespace citykiln::ground
