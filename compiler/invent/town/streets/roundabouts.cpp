#include "compiler/invent/town/streets/roundabouts.h"

#include <algorithm>

#include "compiler/geometry/mathematics.h"
#include "compiler/geometry/segment.h"
#include "compiler/geometry/trig.h"
#include "compiler/invent/town/draws.h"

namespace citykiln::invent {
namespace {

/// An arm of a junction: the segment that leaves the circle, and the vertex outside.
struct CircleArm {
  std::uint32_t outside = 0, street = 0;
  std::vector<std::uint32_t> inside;  ///< Segments to be removed, the last leaves the circle.
  double turns = 0;                   ///< The direction of the place where it does.
};

// follows an arm until it leaves the circle; nothing if it does not do so as a plain road
std::optional<CircleArm> arm_of(const StreetGraph& graph, std::uint32_t middle, std::uint32_t segment) {
  const Vec2 centre = graph.position(middle);
  CircleArm arm;
  std::uint32_t at = middle;
  for (int steps = 0; steps < 4; ++steps) {
    if (graph.segments()[segment].is_bridge) return std::nullopt;
    arm.inside.push_back(segment);
    const std::uint32_t next = graph.other_end(segment, at);
    if (distance(graph.position(next), centre) > kRoundabout_m + 6) {
      arm.outside = next;
      arm.street = graph.segments()[segment].street;
      const Vec2 away = graph.position(next) - centre;
      arm.turns = arctangent2_deg(away.y, away.x) / 360;
      return arm;
    }
    if (graph.degree(next) != 2) return std::nullopt;
    const auto& both = graph.vertices()[next].segments;
    segment = both[0] == segment ? both[1] : both[0];
    at = next;
  }
  return std::nullopt;
}

// the arms of a junction counter-clockwise; empty if it does not suit a roundabout
std::vector<CircleArm> arms_of(const StreetGraph& graph, std::uint32_t vertex) {
  std::vector<CircleArm> arms;
  for (const std::uint32_t s : graph.vertices()[vertex].segments) {
    const auto arm = arm_of(graph, vertex, s);
    if (!arm) return {};
    arms.push_back(*arm);
  }
  std::ranges::sort(arms, {}, &CircleArm::turns);
  for (std::size_t i = 0; i < arms.size(); ++i) {
    const double gap = i + 1 < arms.size() ? arms[i + 1].turns - arms[i].turns : arms[0].turns + 1 - arms[i].turns;
    if (gap < 0.12) return {};
  }
  return arms;
}

// true if no other road comes near the circle
bool is_circle_free(const StreetGraph& graph, std::uint32_t vertex, const std::vector<CircleArm>& arms) {
  const Vec2 centre = graph.position(vertex);
  const double room_m = kRoundabout_m + 9;
  Box2 box;
  box.grow(centre);
  for (const std::uint32_t s : graph.near(box.widened(room_m))) {
    const StreetSegment& segment = graph.segments()[s];
    if (distance_to_segment(graph.position(segment.a), graph.position(segment.b), centre) > room_m) continue;
    const bool is_of_arm = std::ranges::any_of(arms, [&](const CircleArm& arm) {
      return std::ranges::find(arm.inside, s) != arm.inside.end() || segment.a == arm.outside ||
             segment.b == arm.outside;
    });
    if (!is_of_arm) return false;
  }
  return true;
}

void make_circle(StreetGraph& graph, std::uint32_t vertex, const std::vector<CircleArm>& arms) {
  const Vec2 centre = graph.position(vertex);
  const StreetClass ring_class = graph.streets[arms[0].street].street_class;
  const auto ring = static_cast<std::uint32_t>(graph.streets.size());
  graph.streets.push_back({ring_class, {}, true});
  std::vector<std::uint32_t> circle;
  for (std::size_t i = 0; i < arms.size(); ++i) {
    for (const std::uint32_t s : arms[i].inside) graph.remove_segment(s);
    const double next = i + 1 < arms.size() ? arms[i + 1].turns : arms[0].turns + 1, gap = next - arms[i].turns;
    const int steps = std::max(2, static_cast<int>(gap * 16));
    for (int k = 0; k < steps; ++k)
      circle.push_back(graph.add_vertex(centre + direction_of(arms[i].turns + gap * k / steps) * kRoundabout_m));
    graph.add_segment(circle[circle.size() - static_cast<std::size_t>(steps)], arms[i].outside, arms[i].street);
  }
  for (std::size_t i = 0; i < circle.size(); ++i) graph.add_segment(circle[i], circle[(i + 1) % circle.size()], ring);
}

}  // namespace

std::vector<Vec2> make_roundabouts(const TownPlan& plan, StreetGraph& graph) {
  std::vector<Vec2> middles;
  if (plan.settings.kind == TownKind::kVillage) return middles;
  const auto count = static_cast<std::uint32_t>(graph.vertices().size());
  for (std::uint32_t v = 0; v < count; ++v) {
    const Vec2 p = graph.position(v);
    const double density = plan.density.at(p);
    if (graph.degree(v) < 3 || density < kTownEdge || density > 0.62 || plan.water.at(p) < 30) continue;
    if (!Draws(plan.settings.seed, "roundabout", v).chance(0.6)) continue;
    if (std::ranges::any_of(middles, [&](Vec2 q) { return distance(p, q) < 350; })) continue;
    const std::vector<CircleArm> arms = arms_of(graph, v);
    if (arms.empty() || !is_circle_free(graph, v, arms) || std::abs(p.x) > plan.half_m() - 40 ||
        std::abs(p.y) > plan.half_m() - 40)
      continue;
    make_circle(graph, v, arms);
    middles.push_back(p);
  }
  return middles;
}

}  // namespace citykiln::invent
