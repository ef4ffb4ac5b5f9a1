#include "compiler/ground/water/descending_fit.h"

#include <algorithm>
#include <limits>

namespace citykiln::ground {
namespace {

// Where the slope of a cost grows, and by how much.
struct Bend {
  double height_m;
  std::int64_t by;
};

// The cost of all that lies upstream, as a function of the height here, right of its lowest place: it is flat left of
// it, since what is upstream may lie higher. A heap, the lowest bend first.
class UpstreamCost {
 public:
  void add(Bend bend) {
    bends_.push_back(bend);
    std::push_heap(bends_.begin(), bends_.end(), is_higher);
  }

  void add(UpstreamCost&& other) {
    if (bends_.size() < other.bends_.size()) bends_.swap(other.bends_);
    for (const Bend bend : other.bends_) add(bend);
    other.bends_ = {};
  }

  // Takes away bends that together turn a slope of -falling level; returns where it turns.
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
  static bool is_higher(const Bend& a, const Bend& b) { return a.height_m > b.height_m; }
  std::vector<Bend> bends_;
};

// The lowest best height of each node if nothing downstream bound it.
std::vector<double> unbound_heights(const FlowGraph& flow) {
  std::vector<UpstreamCost> costs(flow.pulls.size());
  std::vector<double> heights(flow.pulls.size());
  for (std::size_t i = flow.pulls.size(); i-- > 0;) {
    std::int64_t falling = 0;
    for (const WeightedHeight& pull : flow.pulls[i]) {
      costs[i].add({pull.height_m, pull.below + pull.above});
      falling += pull.below;
    }
    heights[i] = costs[i].take(falling);
    if (!flow.downstream[i].empty()) costs[*std::ranges::min_element(flow.downstream[i])].add(std::move(costs[i]));
  }
  return heights;
}

// What parts from a river begins no higher than it.
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
