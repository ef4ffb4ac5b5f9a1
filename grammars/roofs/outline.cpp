#include "grammars/roofs/outline.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <map>
#include <optional>

#include "compiler/geometry/polygons/overlay.h"
#include "compiler/geometry/ring_crossing.h"
#include "compiler/geometry/snap.h"
#include "grammars/roofs/facet.h"
#include "grammars/roofs/raise_facets.h"

namespace citykiln::roofs {
namespace {

// How far corners that touch are moved inward: above the rounding error of the skeleton, and less where that would turn
// over a sliver.
constexpr std::array kMovedInward_m = {0x1p-5, 0x1p-7, 0x1p-9};

// The sides of narrower spikes coincide up to the snapping of the map: one and a half grid steps.
constexpr double kSpike_m = 0x1.8p-7;

bool is_spike(Vec2 from, Vec2 tip, Vec2 to) {
  const Vec2 out = from - tip, back = to - tip;
  return dot(out, back) > 0 && std::abs(cross(out, back)) <= kSpike_m * std::max(length(out), length(back));
}

// Removes thin spikes from a ring that crosses itself.
Ring without_crossed_spikes(Ring ring) {
  for (std::size_t i = 0; i < ring.size() && ring.size() > 3; ++i) {
    const std::size_t n = ring.size();
    if (!is_spike(ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]) || is_simple(ring)) continue;
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
    i = static_cast<std::size_t>(-1);
  }
  return ring;
}

Ring cleaned(const Ring& ring, bool is_outer) {
  Ring kept = without_crossed_spikes(without_repeats(ring));
  const double area = signed_area_m2(kept);
  if (kept.size() < 3 || area == 0) return {};
  if ((area > 0) != is_outer) std::reverse(kept.begin(), kept.end());
  return kept;
}

Vec2 inward_at(const Ring& ring, std::size_t i) {
  const std::size_t n = ring.size();
  const Vec2 in = unit(ring[i] - ring[(i + n - 1) % n]), out = unit(ring[(i + 1) % n] - ring[i]);
  const Vec2 bisector = left_of(in + out);
  return length(bisector) > 0 ? unit(bisector) : left_of(in);
}

using Count = std::map<Vec2, int>;

Ring moved_inward(const Ring& ring, const Count& count, double by_m) {
  Ring moved = ring;
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (count.at(ring[i]) > 1) moved[i] = snapped(ring[i] + inward_at(ring, i) * by_m);
  return moved;
}

Polygon moved_inward(const Polygon& polygon, const Count& count) {
  Polygon moved;
  for (const double by_m : kMovedInward_m) {
    moved = {moved_inward(polygon.outer, count, by_m), {}};
    for (const Ring& hole : polygon.holes) moved.holes.push_back(moved_inward(hole, count, by_m));
    if (signed_area_m2(moved.outer) > 0 && is_simple_polygon(moved)) break;
  }
  return moved;
}

// A point just outside of the hole, within the polygon that it belongs to.
Vec2 beside(const Ring& hole) { return (hole[0] + hole[1]) * 0.5 + left_of(unit(hole[1] - hole[0])) * 0x1p-12; }

std::vector<Polygon> with_their_holes(std::vector<Ring> rings) {
  std::vector<Polygon> polygons;
  for (Ring& ring : rings)
    if (signed_area_m2(ring) > 0) polygons.push_back({std::move(ring), {}});
  for (const Ring& hole : rings) {
    if (hole.empty() || signed_area_m2(hole) >= 0) continue;
    Polygon* owner = nullptr;
    for (Polygon& polygon : polygons)
      if (winding_number(polygon.outer, beside(hole)) != 0 &&
          (!owner || signed_area_m2(polygon.outer) < signed_area_m2(owner->outer)))
        owner = &polygon;
    if (owner) owner->holes.push_back(hole);
  }
  return polygons;
}

// True if all corners between two kept corners are close to the segment between these.
bool may_skip(const Ring& ring, std::size_t from, std::size_t to, double drop_m) {
  const Vec2 a = ring[from], b = ring[to % ring.size()];
  if (a == b) return false;
  const Plane side = distance_left_of(a, b);
  for (std::size_t i = from + 1; i < to; ++i) {
    const double along = dot(b - a, ring[i] - a);
    if (std::abs(side.at(ring[i])) > drop_m || along < 0 || along > dot(b - a, b - a)) return false;
  }
  return true;
}

Ring simplified(const Ring& ring, double drop_m) {
  Ring kept;
  for (std::size_t at = 0; at < ring.size();) {
    kept.push_back(ring[at]);
    std::size_t next = at + 1;
    while (next < ring.size() && may_skip(ring, at, next + 1, drop_m)) ++next;
    at = next;
  }
  return kept.size() < 3 ? ring : kept;
}

// The eaves at a corner, relative to it: the ends of those of both walls, and the tip where they meet.
struct EavesCorner {
  Vec2 out, next, tip;
  bool is_left = false, is_sharp = false;  // the tip of a sharp one is far out
};

EavesCorner corner_between(Vec2 a, Vec2 b, Vec2 c, double overhang_m) {
  const Vec2 out = left_of(unit(b - a)) * -overhang_m, next = left_of(unit(c - b)) * -overhang_m, middle = out + next;
  const double reach = dot(middle, middle) / (2 * overhang_m * overhang_m);
  const bool is_sharp = reach < 0.5;
  return {out, next, is_sharp ? middle : middle * (1 / reach), cross(b - a, c - b) > 0, is_sharp};
}

// All walls moved outward until they meet. std::nullopt if one would reverse its direction or has a sharp right corner.
std::optional<Ring> walls_moved_out(const Ring& ring, double overhang_m) {
  const std::size_t n = ring.size();
  Ring from(n), to(n), eaves;
  for (std::size_t i = 0, j = 1; i < n; ++i, j = (j + 1) % n) {
    const EavesCorner corner = corner_between(ring[i], ring[j], ring[(j + 1) % n], overhang_m);
    if (corner.is_sharp && !corner.is_left) return std::nullopt;
    to[i] = snapped(ring[j] + (corner.is_sharp ? corner.out : corner.tip));
    from[j] = snapped(ring[j] + (corner.is_sharp ? corner.next : corner.tip));
  }
  for (std::size_t i = 0, j = 1; i < n; ++i, j = (j + 1) % n) {
    if (dot(to[i] - from[i], ring[j] - ring[i]) <= 0) return std::nullopt;
    eaves.push_back(from[i]);
    if (to[i] != from[j]) eaves.push_back(to[i]);
  }
  return eaves;
}

// The eaves by moved walls; empty if they overlap.
Polygon eaves_by_corners(const Polygon& footprint, double overhang_m) {
  Polygon eaves;
  for (const Ring* ring : rings_of(footprint)) {
    std::optional<Ring> moved = walls_moved_out(*ring, overhang_m);
    if (!moved) return {};
    (ring == &footprint.outer ? eaves.outer : eaves.holes.emplace_back()) = std::move(*moved);
  }
  return is_simple_polygon(eaves) ? eaves : Polygon{};
}

// The strips of walls and the kites of corners, whose union with the footprint is the eaves' outline.
void add_eaves(std::vector<OwnedSegment>& segments, const Ring& ring, double overhang_m) {
  for (std::size_t i = 0, n = ring.size(); i < n; ++i) {
    const Vec2 a = ring[i], b = ring[(i + 1) % n];
    const auto [out, next, tip, is_left, is_sharp] = corner_between(a, b, ring[(i + 2) % n], overhang_m);
    add_ring(segments, Ring{a, a + out, b + out, b}, 0);
    if (!is_left) continue;
    add_ring(segments, is_sharp ? Ring{b, b + out, b + next} : Ring{b, b + out, b + tip, b + next}, 0);
  }
}

Polygon eaves_by_overlay(const Polygon& footprint, double overhang_m) {
  std::vector<OwnedSegment> segments;
  for (const Ring* ring : rings_of(footprint)) {
    add_ring(segments, *ring, 0);
    add_eaves(segments, *ring, overhang_m);
  }
  std::vector<Polygon> eaves = std::move(overlay(segments, 1).front());
  return eaves.size() == 1 && is_simple_polygon(eaves.front()) ? std::move(eaves.front()) : Polygon{};
}

bool are_apart(const Polygon& eaves, const Polygon& footprint) {
  for (const Ring* a : rings_of(eaves))
    for (const Ring* b : rings_of(footprint))
      if (borders_touch(*a, *b)) return false;
  return true;
}

}  // namespace

Polygon cleaned(const Polygon& footprint) {
  Polygon polygon{cleaned(footprint.outer, true), {}};
  if (polygon.outer.empty()) return {};
  for (const Ring& hole : footprint.holes)
    if (Ring kept = cleaned(hole, false); !kept.empty()) polygon.holes.push_back(std::move(kept));
  return polygon;
}

bool is_simple_polygon(const Polygon& polygon) {
  if (!is_simple(polygon.outer) || signed_area_m2(polygon.outer) <= 0) return false;
  for (std::size_t i = 0; i < polygon.holes.size(); ++i) {
    if (!is_simple(polygon.holes[i]) || borders_touch(polygon.holes[i], polygon.outer)) return false;
    if (winding_number(polygon.outer, polygon.holes[i].front()) == 0) return false;
    for (std::size_t j = 0; j < i; ++j)
      if (borders_touch(polygon.holes[i], polygon.holes[j])) return false;
  }
  return true;
}

bool is_convex(const Polygon& polygon) {
  const Ring& ring = polygon.outer;
  const std::size_t n = ring.size();
  if (!polygon.holes.empty() || n < 3) return false;
  for (std::size_t i = 0; i < n; ++i)
    if (cross(ring[(i + 1) % n] - ring[i], ring[(i + 2) % n] - ring[(i + 1) % n]) < 0) return false;
  return is_simple(ring);
}

std::vector<Polygon> split_into_simple(const Polygon& footprint) {
  if (is_simple_polygon(footprint)) return {footprint};
  // the eaves of a flat roof are the rings of the area, split where they touch
  const Roof flat = raise_facets(footprint, {}).roof;
  std::vector<Ring> rings;
  Count count;
  for (const auto& eaves : flat.eaves) {
    Ring& ring = rings.emplace_back();
    for (const std::uint32_t v : eaves) ring.push_back(in_plan(flat.positions[v]));
    for (const Vec2 p : ring) ++count[p];
  }
  std::vector<Polygon> polygons = with_their_holes(std::move(rings));
  for (Polygon& polygon : polygons) polygon = moved_inward(polygon, count);
  polygons.erase(
      std::remove_if(polygons.begin(), polygons.end(), [](const Polygon& p) { return !is_simple_polygon(p); }),
      polygons.end());
  return polygons;
}

Polygon simplified(const Polygon& polygon, double drop_m) {
  assert(drop_m >= 0);
  Polygon kept{simplified(polygon.outer, drop_m), {}};
  for (const Ring& hole : polygon.holes) kept.holes.push_back(simplified(hole, drop_m));
  return kept;
}

Polygon offset_eaves(const Polygon& footprint, double overhang_m) {
  if (overhang_m < 8 * kQuantum_m || !is_simple_polygon(footprint)) return {};
  Polygon eaves = eaves_by_corners(footprint, overhang_m);
  if (eaves.outer.empty()) eaves = eaves_by_overlay(footprint, overhang_m);
  return are_apart(eaves, footprint) ? eaves : Polygon{};
}

}  // namespace citykiln::roofs
