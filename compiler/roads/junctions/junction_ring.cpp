#include "compiler/roads/junctions/junction_ring.h"

#include <algorithm>
#include <cassert>

#include "compiler/geometry/ring_crossing.h"
#include "compiler/geometry/snap.h"
#include "compiler/roads/junctions/taper.h"

namespace citykiln::roads {
namespace {

// An arm's edges. `right` runs from the node out to the middle of the cut, `left` from there back.
struct Edges {
  Polyline right, left;
};

// Offsets a path to both sides, or returns nothing where it bends too sharply for mitres.
std::optional<Edges> edges_of(const Polyline& path, const ArmLine& line) {
  constexpr double kSharpestCosine = 0.5;
  Edges edges;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Vec2 before = unit(path[i > 0 ? i : 1] - path[i > 0 ? i - 1 : 0]);
    const Vec2 after = i + 1 < path.size() ? unit(path[i + 1] - path[i]) : before;
    if (dot(before, after) < kSharpestCosine) return std::nullopt;
    const Vec2 off = mitre_of(before, after);
    edges.left.push_back(path[i] + off * line.left_m);
    edges.right.push_back(path[i] - off * line.right_m);
  }
  edges.left.push_back(path.back());
  std::ranges::reverse(edges.left);
  edges.right.push_back(path.back());
  return edges;
}

// The connection from one arm's left edge to the next arm's right edge: the first left_count points of the left edge,
// `between`, then the right edge from right_from on.
struct Turn {
  std::size_t left_count = 0, right_from = 0;
  Ring between;
};

// The first crossing of the left edge, walked inwards, with the next arm's right edge. Arms that do not part before
// their cuts cross at a cut.
std::optional<Turn> first_meeting(const Polyline& left, const Polyline& right) {
  for (std::size_t i = 0; i + 1 < left.size(); ++i) {
    std::optional<Turn> first;
    double least = 2;
    for (std::size_t j = 0; j + 1 < right.size(); ++j) {
      const Vec2 u = left[i + 1] - left[i], v = right[j + 1] - right[j], gap = right[j] - left[i];
      const double det = cross(u, v);
      if (det == 0) continue;
      const double s = cross(gap, v) / det, t = cross(gap, u) / det;
      if (s < 0 || s > 1 || t < 0 || t > 1 || s >= least) continue;
      least = s;
      first = Turn{i + 1, j + 1, {left[i] + u * s}};
    }
    if (first) return first;
  }
  return std::nullopt;
}

// The number of points of an edge beyond a tangent point, counted from the middle of the cut inwards.
std::size_t count_beyond(const Polyline& edge, const TangentPoint& touch) {
  const std::size_t inner = touch.along_m < 0 ? 0 : touch.segment + 1;
  // the middle of the cut always counts
  return edge.size() - std::min(inner, edge.size() - 1);
}

// Appends the points of a fillet's arc, from kerb to kerb, snapped; one point if the radius is 0.
void add_fillet(const Fillet& fillet, Ring& ring) {
  ring.push_back(snapped(fillet.arm.at));
  if (fillet.radius_m == 0) return;
  add_arc(fillet.centre, unit(fillet.arm.at - fillet.centre), unit(fillet.next.at - fillet.centre), fillet.radius_m, 3,
          ring);
  ring.push_back(snapped(fillet.next.at));
}

Turn rounded(const Polyline& left, const Polyline& right, const Fillet& fillet) {
  Turn turn{count_beyond(left, fillet.arm), right.size() - count_beyond(right, fillet.next), {}};
  add_fillet(fillet, turn.between);
  return turn;
}

// An arc around the outside of a bend.
Turn outside(const ArmLine& arm, const ArmLine& next, std::size_t left_count) {
  Turn turn{left_count, 0, {}};
  const Vec2 from = left_of(arm.along), to = left_of(next.along) * -1;
  const double half = std::min(arm.left_m, next.right_m);
  // on a nearly straight line the two ends are neighbours already
  if (dot(from, to) < 0.94 && cross(from, to) > 0) add_arc(arm.from, from, to, half, 2, turn.between);
  return turn;
}

// The connection from an arm to the next one, if there is a valid one.
std::optional<Turn> turn_between(const Junction& junction, const std::vector<Edges>& edges,
                                 const JunctionArms& junction_arms, std::uint32_t arm, std::uint32_t next) {
  const Cut &cut = junction.cuts[arm], &next_cut = junction.cuts[next];
  const Polyline &left = edges[arm].left, &right = edges[next].right;
  const auto fillet = fillet_between(junction_arms.paths[arm], junction_arms.paths[next], cut.radius_m);
  if (fillet && fillet->arm.along_m <= cut.length_m && fillet->next.along_m <= next_cut.length_m)
    return rounded(left, right, *fillet);
  if (auto meeting = first_meeting(left, right)) return meeting;
  // the cut of one arm lies within the other
  if (corner_between(junction_arms.lines[arm], junction_arms.lines[next])) return std::nullopt;
  return outside(junction_arms.lines[arm], junction_arms.lines[next], left.size());
}

void push(Ring& ring, std::span<const Vec2> points) {
  for (const Vec2 p : points) ring.push_back(snapped(p));
}

bool has_spike(const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (is_spike(ring, i)) return true;
  return false;
}

bool is_sound(const Ring& ring, Vec2 place) {
  return ring.size() >= 3 && !has_spike(ring) && signed_area_m2(ring) > 0 && winding_number(ring, place) == 1 &&
         is_simple(ring);
}

void push_up_to(Ring& ring, const Polyline& axis, const TangentPoint& touch) {
  const Vec2 along = unit(axis[touch.segment + 1] - axis[touch.segment]);
  ring.insert(ring.end(), axis.begin(), axis.begin() + static_cast<std::ptrdiff_t>(touch.segment) + 1);
  ring.push_back(axis[touch.segment] + along * dot(touch.at - axis[touch.segment], along));
}

// The edges of all arms, or nothing where an arm has no length or bends too sharply.
std::optional<std::vector<Edges>> edges_of_arms(const Junction& junction, std::span<const Road> roads,
                                                std::span<const Arm> arms, const JunctionArms& junction_arms) {
  std::vector<Edges> edges(arms.size());
  for (const std::uint32_t arm : junction_arms.order) {
    const double length = junction.cuts[arm].length_m;
    if (length <= 0) return std::nullopt;
    auto both = edges_of(arm_axis(roads, arms[arm], length), junction_arms.lines[arm]);
    if (!both) return std::nullopt;
    edges[arm] = std::move(*both);
  }
  return edges;
}

// The connections from each arm of `order` to its next one, or nothing where one is missing.
std::optional<std::vector<Turn>> turns_of(const Junction& junction, const std::vector<Edges>& edges,
                                          const JunctionArms& junction_arms) {
  std::vector<Turn> turns;
  for (std::size_t i = 0; i < junction_arms.order.size(); ++i) {
    const std::uint32_t arm = junction_arms.order[i], next = junction_arms.order[(i + 1) % junction_arms.order.size()];
    auto turn = turn_between(junction, edges, junction_arms, arm, next);
    if (!turn) return std::nullopt;
    turns.push_back(std::move(*turn));
  }
  return turns;
}

}  // namespace

bool is_spike(const Ring& ring, std::size_t i) {
  assert(i < ring.size());
  constexpr double kSpikeCosine = 0.97;
  const Vec2 before = ring[(i + ring.size() - 1) % ring.size()] - ring[i],
             after = ring[(i + 1) % ring.size()] - ring[i];
  return cross(after, before) >= 0 && dot(before, after) > kSpikeCosine * length(before) * length(after);
}

void add_arc(Vec2 centre, Vec2 from, Vec2 to, double radius_m, int halvings, Ring& ring) {
  assert(halvings >= 0);
  if (halvings == 0) return;
  const Vec2 middle = unit(from + to);
  add_arc(centre, from, middle, radius_m, halvings - 1, ring);
  ring.push_back(snapped(centre + middle * radius_m));
  add_arc(centre, middle, to, radius_m, halvings - 1, ring);
}

std::optional<Ring> corner_ring(const ArmPath& arm, const ArmPath& next, const Fillet& fillet) {
  Ring inward, ring;
  push_up_to(ring, arm.axis, fillet.arm);
  add_fillet(fillet, ring);
  push_up_to(inward, next.axis, fillet.next);
  ring.insert(ring.end(), inward.rbegin(), inward.rend());
  for (Vec2& p : ring) p = snapped(p);
  ring = without_repeats(ring);
  if (ring.size() < 3 || signed_area_m2(ring) <= 0 || !is_simple(ring)) return std::nullopt;
  return ring;
}

JunctionArms junction_arms(const Junction& junction, std::span<const Road> roads, std::span<const Arm> arms) {
  assert(arms.size() == junction.cuts.size());
  JunctionArms all;
  for (const Arm& arm : arms) {
    all.lines.push_back(arm_line(roads, arm));
    all.paths.push_back(arm_path(roads, arm));
  }
  all.next = next_at_node(all.lines);
  for (const std::uint32_t a : counter_clockwise(all.lines, citykiln::box_of(junction.nodes).centre()))
    if (junction.cuts[a].length_m != kWholeLink_m) all.order.push_back(a);
  // arms are sorted by node
  for (std::size_t from = 0, p = 0; p < junction.nodes.size(); ++p) {
    std::size_t to = from;
    while (to < arms.size() && all.lines[to].from == junction.nodes[p]) ++to;
    all.disks_m.push_back(disk_radius_m(roads, arms.subspan(from, to - from)));
    from = to;
  }
  return all;
}

std::optional<Ring> trace_outline_unchecked(const Junction& junction, std::span<const Road> roads,
                                            std::span<const Arm> arms, const JunctionArms& junction_arms) {
  assert(arms.size() == junction.cuts.size());
  const std::size_t count = junction_arms.order.size();
  if (junction.nodes.size() != 1 || count < 2) return std::nullopt;
  const auto edges = edges_of_arms(junction, roads, arms, junction_arms);
  const auto turns = edges ? turns_of(junction, *edges, junction_arms) : std::nullopt;
  if (!turns) return std::nullopt;
  Ring ring;
  for (std::size_t i = 0; i < count; ++i) {
    const Edges& arm = (*edges)[junction_arms.order[i]];
    const Turn &before = (*turns)[(i + count - 1) % count], &after = (*turns)[i];
    push(ring, std::span(arm.right).subspan(before.right_from));
    push(ring, std::span(arm.left).first(after.left_count));
    push(ring, after.between);
  }
  return without_repeats(ring);
}

std::optional<Ring> trace_outline(const Junction& junction, std::span<const Road> roads, std::span<const Arm> arms,
                                  const JunctionArms& junction_arms) {
  if (junction.nodes.size() != 1 || junction_arms.disks_m.front() > 0) return std::nullopt;
  const auto taper = [&] {
    return taper_ring(junction_arms.paths[0], junction.cuts[0].length_m, junction_arms.paths[1],
                      junction.cuts[1].length_m);
  };
  auto ring = is_taper(junction.family, junction_arms.lines)
                  ? taper()
                  : trace_outline_unchecked(junction, roads, arms, junction_arms);
  if (ring && !is_sound(*ring, junction.nodes.front())) ring.reset();
  return ring;
}

}  // namespace citykiln::roads
