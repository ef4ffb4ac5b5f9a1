#include "compiler/ground/profiles/smoothing/grade_limits.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <limits>

#include "compiler/ground/profiles/graph/graph_rules.h"
#include "compiler/ground/profiles/graph/graph_walk.h"
#include "compiler/ground/profiles/graph/lowering_caps.h"
#include "compiler/ground/profiles/graph/rigid_units.h"

namespace citykiln::ground {
namespace {

// Finds how far units must be lowered: a walk from each foot of a too steep leg carries the excess of heights over the
// limits outwards.
class Lowering {
 public:
  Lowering(const ProfileGraph& graph, const RigidUnits& units, std::span<const double> z_m, GradeInfluence influence,
           std::span<const double> steepness = {})
      : graph_(graph),
        units_(units),
        z_m_(z_m),
        influence_(influence),
        steepness_(steepness),
        excess_m_(units.count(), 0),
        low_m_(units.count(), 0),
        times_(units.count(), 0) {}

  /// Returns the change per unit, <= 0. Every foot acts on its own and the largest effect wins, so their order does not
  /// matter.
  std::vector<double> run() {
    for (std::uint32_t u = 0; u < units_.count(); ++u)
      if (is_foot(u)) spread(u);
    return std::move(low_m_);
  }

 private:
  using Key = std::pair<double, std::uint32_t>;

  double steepness_of(std::uint32_t node, const Leg& leg) const {
    if (steepness_.empty() || !may_be_steeper(graph_, leg.way)) return 1;
    return std::max(steepness_[node], steepness_[leg.to]);
  }

  // Returns the height of a line that rises along the leg at its limit, less the height at the leg's end.
  double excess_beyond_m(std::uint32_t node, const Leg& leg) const {
    return steepness_of(node, leg) * limit_of(graph_, leg) * leg.length_m - (z_m_[leg.to] - z_m_[node]);
  }

  bool is_foot(std::uint32_t unit) const {
    return std::ranges::any_of(units_.members(unit), [&](std::uint32_t n) {
      return std::ranges::any_of(
          graph_.legs_of(n), [&](const Leg& leg) { return units_.of[leg.to] != unit && excess_beyond_m(n, leg) < 0; });
    });
  }

  void spread(std::uint32_t foot) {
    const Vec2 at = graph_.nodes[units_.members(foot).front()].at;
    queue_.emplace_back(0, foot);
    while (!queue_.empty()) {
      std::ranges::pop_heap(queue_, std::greater<>());
      const auto [key, unit] = queue_.back();
      queue_.pop_back();
      const double left = 1 - distance(graph_.nodes[units_.members(unit).front()].at, at) / influence_.radius_m;
      if (left <= 0) continue;
      low_m_[unit] = std::min(low_m_[unit], std::max(excess_m_[unit], -influence_.max_m * left));
      go_on(unit);
    }
    for (const std::uint32_t unit : touched_) excess_m_[unit] = 0, times_[unit] = 0;
    touched_.clear();
    queue_.clear();
  }

  void go_on(std::uint32_t unit) {
    constexpr double kLess_m = 1e-9;
    // two junction planes side by side that tilt apart would lower each other for ever
    constexpr int kTimes = 3;
    for (const std::uint32_t n : units_.members(unit)) {
      for (const Leg& leg : graph_.legs_of(n)) {
        const std::uint32_t to = units_.of[leg.to];
        const double excess_m = excess_m_[unit] + excess_beyond_m(n, leg);
        if (to == unit || excess_m > excess_m_[to] - kLess_m || times_[to] >= kTimes) continue;
        ++times_[to];
        excess_m_[to] = excess_m;
        touched_.push_back(to);
        queue_.emplace_back(z_m_[leg.to] + excess_m, to);
        std::ranges::push_heap(queue_, std::greater<>());
      }
    }
  }

  const ProfileGraph& graph_;
  const RigidUnits& units_;
  std::span<const double> z_m_;
  GradeInfluence influence_;
  std::span<const double> steepness_;
  std::vector<double> excess_m_, low_m_;
  std::vector<int> times_;
  std::vector<std::uint32_t> touched_;
  std::vector<Key> queue_;
};

// Returns how far each unit may rise below the caps of pinned nodes.
std::vector<double> room_of(const ProfileGraph& graph, const RigidUnits& units, std::span<const double> z_m) {
  GraphWalk walk(graph);
  const std::vector<double> cap_m = caps_near_pinned(graph, walk, z_m);
  std::vector<double> room_m(units.count(), std::numeric_limits<double>::infinity());
  for (std::uint32_t n = 0; n < z_m.size(); ++n) room_m[units.of[n]] = std::min(room_m[units.of[n]], cap_m[n] - z_m[n]);
  return room_m;
}

}  // namespace

std::vector<double> lowered_to_limits(const ProfileGraph& graph, std::span<const double> z_m,
                                      GradeInfluence influence) {
  assert(z_m.size() == graph.nodes.size() && influence.radius_m > 0);
  const RigidUnits units(graph);
  const std::vector<double> low_m = Lowering(graph, units, z_m, influence).run();
  std::vector<double> lowered;
  for (std::uint32_t n = 0; n < z_m.size(); ++n) lowered.push_back(z_m[n] + low_m[units.of[n]]);
  return lowered;
}

std::vector<double> limit_grades(const ProfileGraph& graph, std::span<const double> z_m,
                                 std::span<const double> steepness) {
  assert(z_m.size() == graph.nodes.size());
  assert(steepness.empty() || steepness.size() == z_m.size());
  const RigidUnits units(graph);
  const std::vector<double> turned_m = negated(z_m);
  const std::vector<double> down_m = Lowering(graph, units, z_m, {}, steepness).run();
  const std::vector<double> up_m = Lowering(graph, units, turned_m, {}, steepness).run();
  const auto stays = [](double m) { return m == 0; };
  if (std::ranges::all_of(down_m, stays) && std::ranges::all_of(up_m, stays)) return {z_m.begin(), z_m.end()};
  const std::vector<double> room_up_m = room_of(graph, units, z_m), room_down_m = room_of(graph, units, turned_m);
  std::vector<double> limited;
  for (std::uint32_t n = 0; n < z_m.size(); ++n) {
    const std::uint32_t u = units.of[n];
    const double move_m = (down_m[u] - up_m[u]) / 2;
    limited.push_back(z_m[n] + std::max(std::min(move_m, room_up_m[u]), -room_down_m[u]));
  }
  return limited;
}

}  // namespace citykiln::ground
