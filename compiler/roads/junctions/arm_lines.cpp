#include "compiler/roads/junctions/arm_lines.h"

#include <algorithm>
#include <limits>

#include "compiler/geometry/snap.h"

namespace citykiln::roads {
namespace {

constexpr double kLookAhead_m = 8;

// Arms less than 1.8 degrees apart count as parallel: they would meet beyond the junction's radius.
constexpr double kParallelSine = 0x1p-5;

// Beyond 160 degrees a corner is too flat to be visible.
constexpr double kStraightCosine = -0.94;

// 0 for bearings from east up to west exclusive, counter-clockwise; 1 for the rest.
int half_turn_of_bearing(Vec2 v) { return v.y > 0 || (v.y == 0 && v.x > 0) ? 0 : 1; }

}  // namespace

ArmLine arm_line(std::span<const Road> roads, const Arm& arm) {
  const Polyline path = arm_axis(roads, arm, kLookAhead_m);
  Vec2 along = path.back() - path.front();
  // a loop may return to its start
  if (along == Vec2{}) along = path[1] - path[0];
  return {
      .from = path.front(), .along = unit(along), .left_m = arm_left_m(roads, arm), .right_m = arm_right_m(roads, arm)};
}

std::vector<ArmLine> arm_lines(std::span<const Road> roads, std::span<const Arm> arms) {
  std::vector<ArmLine> lines;
  for (const Arm& arm : arms) lines.push_back(arm_line(roads, arm));
  return lines;
}

std::vector<std::uint32_t> counter_clockwise(std::span<const ArmLine> lines, Vec2 centre) {
  std::vector<std::uint32_t> order(lines.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  // on the 2^-10 m grid products are exact, so the order is the same on every machine
  const auto bearing = [&](std::uint32_t i) { return snapped(lines[i].from + lines[i].along * kLookAhead_m - centre); };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const Vec2 u = bearing(a), v = bearing(b);
    if (half_turn_of_bearing(u) != half_turn_of_bearing(v)) return half_turn_of_bearing(u) < half_turn_of_bearing(v);
    const double turn = cross(u, v);
    return turn != 0 ? turn > 0 : a < b;
  });
  return order;
}

std::vector<std::uint32_t> next_at_node(std::span<const ArmLine> lines) {
  std::vector<std::uint32_t> next(lines.size());
  for (std::uint32_t from = 0, to = 0; from < lines.size(); from = to) {
    while (to < lines.size() && lines[to].from == lines[from].from) ++to;
    const std::vector<std::uint32_t> order = counter_clockwise(lines.subspan(from, to - from), lines[from].from);
    for (std::size_t i = 0; i < order.size(); ++i) next[from + order[i]] = from + order[(i + 1) % order.size()];
  }
  return next;
}

std::optional<Corner> corner_between(const ArmLine& arm, const ArmLine& next) {
  const double sine = cross(arm.along, next.along), cosine = dot(arm.along, next.along);
  if (cosine < kStraightCosine || (sine <= 0 && cosine < 1 - kParallelSine * kParallelSine)) return std::nullopt;
  const Vec2 gap = (next.from - left_of(next.along) * next.right_m) - (arm.from + left_of(arm.along) * arm.left_m);
  if (sine < kParallelSine) {
    // side by side with a gap from the start
    if (dot(gap, left_of(arm.along)) > 0) return std::nullopt;
    constexpr double kNever = std::numeric_limits<double>::infinity();
    return Corner{kNever, kNever, kParallelSine};
  }
  return Corner{std::max(0.0, cross(gap, next.along) / sine), std::max(0.0, cross(gap, arm.along) / sine), sine};
}

}  // namespace citykiln::roads
