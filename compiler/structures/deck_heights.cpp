// Distances along decks by Dijkstra (1959). Equal keys settle by the lower station, which changes no distance.
#include "compiler/structures/deck_heights.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "compiler/geometry/snap.h"

namespace citykiln::structures {
namespace {

constexpr double kUnreached = std::numeric_limits<double>::infinity();
using Key = std::pair<double, std::uint32_t>;
using Queue = std::priority_queue<Key, std::vector<Key>, std::greater<>>;

// Lowers `value` along legs, `rate` a metre, from all that is queued; `reached` hears of each station once, and says
// whether to go on from it.
template <typename Reached>
void spread(const DeckGraph& graph, std::vector<double>& value, Queue& queue, double rate, Reached reached) {
  while (!queue.empty()) {
    const auto [v, station] = queue.top();
    queue.pop();
    if (v > value[station] || !reached(station)) continue;
    for (const Leg& leg : graph.stations[station].legs) {
      const double beyond = v + rate * leg.length_m;
      if (beyond >= value[leg.to]) continue;
      value[leg.to] = beyond;
      queue.push({beyond, leg.to});
    }
  }
}

// Heights of anchors, weighted by the inverse of their distance: between two anchors this is the straight line.
struct Line {
  const DeckGraph& graph;
  std::vector<double> weighted_m, weight, distance_m;

  explicit Line(const DeckGraph& g)
      : graph(g), weighted_m(g.stations.size()), weight(g.stations.size()), distance_m(g.stations.size(), kUnreached) {}

  void pull(std::uint32_t anchor) {
    std::vector<std::uint32_t> touched;
    Queue queue;
    distance_m[anchor] = 0;
    queue.push({0, anchor});
    spread(graph, distance_m, queue, 1, [&](std::uint32_t station) {
      touched.push_back(station);
      return station == anchor || !graph.stations[station].is_anchored;
    });
    for (const std::uint32_t station : touched) {
      const double share = 1 / std::max(distance_m[station], kQuantum_m);
      weighted_m[station] += share * graph.stations[anchor].ground_m;
      weight[station] += share;
      distance_m[station] = kUnreached;
    }
  }

  double height_m(std::uint32_t station) const {
    const Station& s = graph.stations[station];
    return s.is_anchored || weight[station] == 0 ? s.ground_m : weighted_m[station] / weight[station];
  }
};

std::vector<double> line_heights(const DeckGraph& graph) {
  Line line(graph);
  for (std::uint32_t i = 0; i < graph.stations.size(); ++i)
    if (graph.stations[i].is_anchored) line.pull(i);
  std::vector<double> heights(graph.stations.size());
  for (std::uint32_t i = 0; i < heights.size(); ++i) heights[i] = line.height_m(i);
  return heights;
}

// The highest lift that nowhere changes by more than the grade, is 0 at anchors and nowhere above what is wanted.
std::vector<double> lifts(const DeckGraph& graph, const std::vector<double>& line_m) {
  // counted from below zero, so that the deck stays level next to its anchors
  constexpr double kStart_m = -kBridgeGrade * kLevelEnd_m;
  std::vector<double> lift(graph.stations.size());
  Queue queue;
  for (std::uint32_t i = 0; i < lift.size(); ++i) {
    const Station& s = graph.stations[i];
    lift[i] = s.is_anchored ? kStart_m : std::clamp(s.ground_m + s.clearance_m - line_m[i], 0.0, s.clearance_m);
    queue.push({lift[i], i});
  }
  spread(graph, lift, queue, kBridgeGrade, [](std::uint32_t) { return true; });
  for (double& l : lift) l = std::max(l, 0.0);
  return lift;
}

}  // namespace

std::vector<double> deck_heights(const DeckGraph& graph) {
  std::vector<double> heights = line_heights(graph);
  const std::vector<double> lift = lifts(graph, heights);
  for (std::size_t i = 0; i < heights.size(); ++i) heights[i] = snapped(heights[i] + lift[i]);
  return heights;
}

}  // namespace citykiln::structures
