// Outlines of junctions: rings from cuts and corners, then polygons that share no area.
#include <algorithm>
#include <array>
#include <cassert>

#include "compiler/contract/system/for_each_slot.h"
#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/polygons/overlay.h"
#include "compiler/geometry/ring_crossing.h"
#include "compiler/geometry/snap.h"
#include "compiler/roads/generate.h"
#include "compiler/roads/junctions/arm_lines.h"
#include "compiler/roads/junctions/junction.h"
#include "compiler/roads/junctions/junction_ring.h"

namespace citykiln::roads {
namespace {

// The axis of an arm up to the next node of its junction.
Polyline link_axis(std::span<const Road> roads, const Arm& arm, std::span<const Vec2> nodes) {
  const Polyline& axis = roads[arm.road].axis;
  const std::size_t end = end_of_link(roads[arm.road], arm, nodes);
  Polyline path(axis.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(arm.vertex, end)),
                axis.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(arm.vertex, end)) + 1);
  if (arm.step < 0) std::ranges::reverse(path);
  return path;
}

void stroke_arm(std::span<const Road> roads, const Arm& arm, const Cut& cut, std::span<const Vec2> nodes,
                std::vector<Ring>& rings) {
  const ArmLine line = arm_line(roads, arm);
  Strip piece{.id = {},
              .axis = cut.length_m == kWholeLink_m ? link_axis(roads, arm, nodes) : arm_axis(roads, arm, cut.length_m),
              .left_m = line.left_m,
              .right_m = line.right_m};
  piece.axis.back() = snapped(piece.axis.back());
  if (piece.axis.back() == piece.axis[piece.axis.size() - 2]) piece.axis.pop_back();
  if (piece.axis.size() < 2) return;
  for (Ring& ring : stroke(piece)) rings.push_back(std::move(ring));
}

// A disk about a node, as a 16-gon or, above 4 m, a 32-gon.
Ring disk_at(Vec2 place, double radius_m) {
  constexpr double kFine_m = 4;
  const int halvings = radius_m > kFine_m ? 3 : 2;
  Ring ring;
  const std::array<Vec2, 4> quarters = {Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1}};
  for (int q = 0; q < 4; ++q) {
    ring.push_back(snapped(place + quarters[q] * radius_m));
    add_arc(place, quarters[q], quarters[(q + 1) % 4], radius_m, halvings, ring);
  }
  return ring;
}

// The radius of the disk that fills the wedge between arms more than half a turn apart, 0 where there is none: the
// smaller half width of the second widest arm, because a wide street that ends on a narrow one opens no wedge.
double open_half_m(const JunctionArms& junction_arms, Vec2 place) {
  constexpr double kWedgeSine = -0.08;
  double widest = 0, second = 0;
  bool is_open = false;
  for (std::size_t a = 0; a < junction_arms.lines.size(); ++a) {
    const ArmLine& line = junction_arms.lines[a];
    if (line.from != place) continue;
    is_open |= cross(line.along, junction_arms.lines[junction_arms.next[a]].along) < kWedgeSine;
    const double half = std::min(line.left_m, line.right_m);
    second = std::max(second, std::min(widest, half));
    widest = std::max(widest, half);
  }
  return !is_open ? 0 : second > 0 ? second : widest;
}

void push_ring(std::vector<Ring>& rings, const Ring& ring) {
  Ring clean = without_repeats(ring);
  if (clean.size() >= 3 && signed_area_m2(clean) > 0) rings.push_back(std::move(clean));
}

// The rings of a junction, their box and the junction's rank.
struct Covered {
  std::vector<Ring> rings;
  Box2 box;
  int priority = 0;
};

// Removes spikes, corner by corner: subtracting other junctions can leave thin points. May leave less than a triangle.
Ring without_spikes(Ring ring) {
  for (std::size_t i = 0; i < ring.size() && ring.size() >= 3;) {
    if (!is_spike(ring, i)) {
      ++i;
      continue;
    }
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
    i = i > 0 ? i - 1 : 0;
  }
  return ring;
}

std::vector<Polygon> trimmed(std::vector<Polygon> polygons) {
  std::vector<Polygon> sound;
  for (Polygon& polygon : polygons) {
    Ring ring = without_spikes(polygon.outer);
    if (ring.size() < 3 || !is_simple(ring)) continue;
    sound.push_back({std::move(ring), std::move(polygon.holes)});
  }
  return sound;
}

// False where two junctions certainly share no area: only decided for single rings, which are simple.
bool may_share(const Covered& a, const Covered& b) {
  if (a.rings.size() != 1 || b.rings.size() != 1) return true;
  const Ring &r = a.rings.front(), &s = b.rings.front();
  return borders_touch(r, s) || winding_number(r, s.front()) != 0 || winding_number(s, r.front()) != 0;
}

}  // namespace

Box2 box_of(const Junction& junction, double widest_arm_m) {
  assert(!junction.nodes.empty() && widest_arm_m >= 0);
  return citykiln::box_of(junction.nodes).widened(kJunctionRadius_m + 0.75 * widest_arm_m);
}

const Road& main_road(std::span<const Road> roads, std::span<const Arm> arms) {
  assert(!arms.empty());
  const auto rank = [&](const Arm& arm) {
    const Road& road = roads[arm.road];
    return std::tuple(map::values_of(road.surface).priority, width_m(road), road.id);
  };
  return roads[std::ranges::max_element(arms, {}, rank)->road];
}

std::vector<Ring> stroke_pieces(const Junction& junction, std::span<const Road> roads, std::span<const Arm> arms,
                                const JunctionArms& junction_arms) {
  assert(arms.size() == junction.cuts.size());
  std::vector<Ring> rings;
  for (std::size_t a = 0; a < arms.size(); ++a) stroke_arm(roads, arms[a], junction.cuts[a], junction.nodes, rings);
  for (std::size_t p = 0; p < junction.nodes.size(); ++p) {
    const Vec2 place = junction.nodes[p];
    push_ring(rings, disk_at(place, std::max(open_half_m(junction_arms, place), junction_arms.disks_m[p])));
  }
  for (std::uint32_t arm = 0; arm < arms.size(); ++arm) {
    const std::uint32_t next = junction_arms.next[arm];
    const double radius = junction.cuts[arm].radius_m;
    if (radius == 0) continue;
    const auto fillet = fillet_between(junction_arms.paths[arm], junction_arms.paths[next], radius);
    if (!fillet) continue;
    if (auto corner = corner_ring(junction_arms.paths[arm], junction_arms.paths[next], *fillet))
      rings.push_back(std::move(*corner));
  }
  return rings;
}

std::vector<Ring> stroke(const Junction& junction, std::span<const Road> roads, std::span<const Arm> arms) {
  assert(arms.size() == junction.cuts.size());
  const JunctionArms all = junction_arms(junction, roads, arms);
  if (auto ring = trace_outline(junction, roads, arms, all)) return {std::move(*ring)};
  return stroke_pieces(junction, roads, arms, all);
}

std::vector<std::vector<Arm>> arms_of(std::span<const Junction> junctions, std::span<const Road> roads) {
  struct NodeOfJunction {
    Family family;
    Vec2 at;
    std::uint32_t junction, number;
    auto operator<=>(const NodeOfJunction&) const = default;
  };
  std::vector<NodeOfJunction> nodes;
  std::vector<std::vector<std::vector<Arm>>> by_node(junctions.size());
  for (std::uint32_t j = 0; j < junctions.size(); ++j) {
    by_node[j].resize(junctions[j].nodes.size());
    for (std::uint32_t n = 0; n < junctions[j].nodes.size(); ++n)
      nodes.push_back({junctions[j].family, junctions[j].nodes[n], j, n});
  }
  std::ranges::sort(nodes);
  for (std::uint32_t road = 0; road < roads.size(); ++road) {
    const Family family = family_of(roads[road].surface);
    for (std::uint32_t v = 0; v < roads[road].axis.size(); ++v) {
      const auto found = std::ranges::lower_bound(nodes, NodeOfJunction{family, roads[road].axis[v], 0, 0});
      if (found == nodes.end() || found->at != roads[road].axis[v] || found->family != family) continue;
      append_arms(roads, road, v, by_node[found->junction][found->number]);
    }
  }
  std::vector<std::vector<Arm>> arms(junctions.size());
  for (std::size_t j = 0; j < junctions.size(); ++j)
    for (const std::vector<Arm>& here : by_node[j]) arms[j].insert(arms[j].end(), here.begin(), here.end());
  return arms;
}

std::size_t end_of_link(const Road& road, const Arm& arm, std::span<const Vec2> nodes) {
  assert(arm.vertex < road.axis.size() && std::ranges::is_sorted(nodes));
  assert(arm.step > 0 ? arm.vertex + 1 < road.axis.size() : arm.vertex > 0);
  std::size_t v = arm.vertex;
  do v = static_cast<std::size_t>(static_cast<std::int64_t>(v) + arm.step);
  while (v > 0 && v + 1 < road.axis.size() && !std::ranges::binary_search(nodes, road.axis[v]));
  return v;
}

std::vector<std::vector<Polygon>> outline_junctions(std::span<const Junction> junctions, std::span<const Road> roads,
                                                    int threads) {
  const std::vector<std::vector<Arm>> arms = arms_of(junctions, roads);
  const auto covered = for_each_slot<Covered>(junctions.size(), threads, [&](std::size_t j) {
    Covered c{stroke(junctions[j], roads, arms[j]), {}, map::values_of(main_road(roads, arms[j]).surface).priority};
    for (const Ring& ring : c.rings)
      for (const Vec2 p : ring) c.box.grow(p);
    return c;
  });
  // junctions whose arms are a millimetre long cover nothing
  std::vector<std::uint32_t> present;
  std::vector<Box2> boxes;
  for (std::uint32_t j = 0; j < covered.size(); ++j)
    if (!covered[j].box.is_empty()) present.push_back(j), boxes.push_back(covered[j].box);
  constexpr double kBucket_m = 64;
  const BoxGrid grid = grid_of(boxes, kBucket_m);
  const auto lies_over = [&](std::uint32_t a, std::uint32_t b) {
    return std::tuple(-covered[a].priority, junctions[a].nodes.front()) <
           std::tuple(-covered[b].priority, junctions[b].nodes.front());
  };
  std::vector<std::vector<std::uint32_t>> above(junctions.size());
  for (std::uint32_t i = 0; i < present.size(); ++i)
    for (const std::uint32_t other : boxes_about(grid, boxes[i]))
      if (boxes[other].touches(boxes[i]) && lies_over(present[other], present[i]))
        above[present[i]].push_back(present[other]);
  return for_each_slot<std::vector<Polygon>>(junctions.size(), threads, [&](std::size_t j) {
    const std::vector<Ring>& rings = covered[j].rings;
    std::vector<OwnedSegment> segments;
    for (const std::uint32_t other : above[j])
      if (may_share(covered[other], covered[j]))
        for (const Ring& ring : covered[other].rings) add_ring(segments, ring, 0);
    if (segments.empty() && rings.size() == 1) return std::vector<Polygon>{{rings.front(), {}}};
    for (const Ring& ring : rings) add_ring(segments, ring, 1);
    return trimmed(std::move(overlay(segments, 2)[1]));
  });
}

}  // namespace citykiln::roads
