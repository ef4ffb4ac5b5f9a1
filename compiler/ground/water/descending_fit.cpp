#include "compiler/ground/water/descending_fit.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace citykiln::ground {
namespace {

// A height at which the slope of a cost function grows, and by how much.
struct CostBend {
  double height_m;
  std::int64_t by;
};

// The cost of all nodes upstream as a function of the height here: convex, piecewise linear, and flat left of its
// minimum, since nodes upstream may lie higher. Stored as a heap of its bends, the lowest first.
class UpstreamCost {
 public:
  void add(CostBend bend) {
    bends_.push_back(bend);
    std::push_heap(bends_.begin(), bends_.end(), is_higher);
  }

  void add(UpstreamCost&& other) {
    if (bends_.size() < other.bends_.size()) bends_.swap(other.bends_);
    for (const CostBend bend : other.bends_) add(bend);
    other.bends_ = {};
  }

  // Removes bends from the left until the slope has risen by `falling`, from -falling to 0; returns where that is: the
  // new minimum.
  double take(std::int64_t falling) {
    double turn_m = bends_.front().height_m;
    while (falling > 0) {
      turn_m = bends_.front().height_m;
      if (bends_.front().by > falling) {
        bends_.front().by -= falling;
        return turn_m;
      }
      falling -= bends_.front().by;
      std::pop_heap(bends_.begin(), bends_.end(), is_higher);
      bends_.pop_back();
    }
    return turn_m;
  }

 private:
  static bool is_higher(const CostBend& a, const CostBend& b) { return a.height_m > b.height_m; }
  std::vector<CostBend> bends_;
};

// Returns each node's lowest best height if nothing downstream limited it. Upstream nodes have higher numbers, so going
// down collects their costs first.
std::vector<double> unbound_heights(const FlowGraph& flow) {
  std::vector<UpstreamCost> costs(flow.given.size());
  std::vector<double> heights(flow.given.size());
  for (std::size_t i = flow.given.size(); i-- > 0;) {
    std::int64_t falling = 0;
    for (const WeightedHeight& height : flow.given[i]) {
      costs[i].add({height.height_m, height.below + height.above});
      falling += height.below;
    }
    heights[i] = costs[i].take(falling);
    if (!flow.downstream[i].empty()) costs[*std::ranges::min_element(flow.downstream[i])].add(std::move(costs[i]));
  }
  return heights;
}

// An arm that leaves a river begins no higher than the river there.
void lower_arms(const FlowGraph& flow, std::vector<double>& heights) {
  for (std::size_t i = heights.size(); i-- > 0;)
    for (const std::uint32_t d : flow.downstream[i]) heights[d] = flow.is_sea[d] ? 0 : std::min(heights[d], heights[i]);
}

void lift_to_sea(const FlowGraph& flow, std::vector<double>& heights) {
  std::vector<bool> reaches_sea = flow.is_sea;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    for (const std::uint32_t d : flow.downstream[i]) reaches_sea[i] = reaches_sea[i] || reaches_sea[d];
    if (reaches_sea[i]) heights[i] = std::max(heights[i], 0.0);
  }
}

}  // namespace

std::vector<double> fit_descending(const FlowGraph& flow) {
  assert(flow.downstream.size() == flow.given.size() && flow.is_sea.size() == flow.given.size());
  assert(std::ranges::none_of(flow.given, [](const auto& given) { return given.empty(); }));
  std::vector<double> heights = unbound_heights(flow);
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (!flow.downstream[i].empty())
      heights[i] = std::max(heights[i], heights[*std::ranges::min_element(flow.downstream[i])]);
    if (flow.is_sea[i]) heights[i] = 0;
  }
  lower_arms(flow, heights);
  lift_to_sea(flow, heights);
  return heights;
}

}  // namespace citykiln::ground
