#include "compiler/geometry/polygons/offset_polygon.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <optional>

#include "compiler/geometry/polygons/overlay.h"
#include "compiler/geometry/ring_crossing.h"
#include "compiler/geometry/snap.h"

namespace citykiln {
namespace {

constexpr double kParallel = 1e-9;  // sine of the angle below which two edges count as parallel

Vec2 direction_of_edge(const Ring& ring, std::size_t i) { return unit(ring[(i + 1) % ring.size()] - ring[i]); }

/// The intersection of the lines of edges e0 and e1 after moving them to the left by d0 and d1, relative to their
/// common corner.
std::optional<Vec2> moved_corner(Vec2 e0, Vec2 e1, double d0, double d1) {
  const double c = cross(e0, e1);
  if (std::abs(c) > kParallel) return (e1 * d0 - e0 * d1) * (1 / c);
  if (dot(e0, e1) > 0 && d0 == d1) return left_of(e1) * d1;
  return std::nullopt;
}

/// True where the moved border passes around the outside of the corner.
bool goes_around(Vec2 e0, Vec2 e1, double d0, double d1) { return cross(e0, e1) * (d0 + d1) < 0; }

// depths count to the left; negative depths move outward
std::optional<Ring> moved_ring(const Ring& ring, std::span<const double> depth_m) {
  const std::size_t n = ring.size();
  Ring moved;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t before = (i + n - 1) % n;
    const Vec2 e0 = direction_of_edge(ring, before), e1 = direction_of_edge(ring, i);
    const double d0 = depth_m[before], d1 = depth_m[i];
    const auto corner = moved_corner(e0, e1, d0, d1);
    if (!corner) return std::nullopt;
    const double reach_m = kMitreLimit * std::max(std::abs(d0), std::abs(d1));
    if (goes_around(e0, e1, d0, d1) && length(*corner) > reach_m) return std::nullopt;
    moved.push_back(ring[i] + *corner);
  }
  for (std::size_t i = 0; i < n; ++i)
    if (dot(moved[(i + 1) % n] - moved[i], direction_of_edge(ring, i)) <= 0) return std::nullopt;
  return moved;
}

Polygon band_between(const Ring& ring, const Ring& moved, std::size_t i) {
  const std::size_t next = (i + 1) % ring.size();
  Polygon band{{ring[i], ring[next], moved[next], moved[i]}, {}};
  if (signed_area_m2(band.outer) < 0) band.outer = {ring[next], ring[i], moved[i], moved[next]};
  band.outer = without_repeats(band.outer);
  return band;
}

// rings that do not touch may still have moved past each other
bool is_nested(const Polygon& polygon) {
  const auto inside = [](const Ring& ring, const Ring& other) { return winding_number(ring, other.front()) != 0; };
  for (const Ring& hole : polygon.holes) {
    if (!inside(polygon.outer, hole)) return false;
    for (const Ring& other : polygon.holes)
      if (&other != &hole && inside(other, hole)) return false;
  }
  return true;
}

bool apart(const Polygon& polygon) {
  const auto rings = rings_of(polygon);
  for (std::size_t i = 0; i < rings.size(); ++i) {
    if (!is_simple(*rings[i])) return false;
    for (std::size_t j = 0; j < i; ++j)
      if (borders_touch(*rings[i], *rings[j])) return false;
  }
  return true;
}

bool adds_up(const Polygon& polygon, const OffsetPolygon& offset) {
  double bands_m2 = 0;
  for (const auto& bands : offset.bands)
    for (const Polygon& band : bands) bands_m2 += area_m2(band);
  const double before_m2 = area_m2(polygon), after_m2 = area_m2(offset.moved.front());
  return std::abs(std::abs(before_m2 - after_m2) - bands_m2) <= 1e-9 * (before_m2 + after_m2);
}

std::optional<OffsetPolygon> offset_by_corners(const Polygon& polygon, std::span<const double> depth_m) {
  OffsetPolygon offset;
  Polygon& moved = offset.moved.emplace_back();
  std::size_t edge = 0;
  for (const Ring* ring : rings_of(polygon)) {
    const auto made = moved_ring(*ring, depth_m.subspan(edge, ring->size()));
    if (!made) return std::nullopt;
    for (std::size_t i = 0; i < ring->size(); ++i, ++edge) {
      auto& bands = offset.bands.emplace_back();
      if (depth_m[edge] != 0) bands.push_back(band_between(*ring, *made, i));
    }
    (ring == &polygon.outer ? moved.outer : moved.holes.emplace_back()) = *made;
  }
  if (!apart(moved) || !is_nested(moved) || !adds_up(polygon, offset)) return std::nullopt;
  return offset;
}

// ---- overlay of strips ----

struct Strips {
  double scale = 1;
  std::vector<OwnedSegment> segments;

  void add(Ring ring, std::uint32_t owner, bool as_it_turns = false) {
    for (Vec2& p : ring) p = snapped(p * scale);
    if (!as_it_turns && signed_area_m2(ring) < 0) std::reverse(ring.begin(), ring.end());
    add_ring(segments, ring, owner);
  }
  void add(const Polygon& polygon, std::uint32_t owner) {
    for (const Ring* ring : rings_of(polygon)) add(*ring, owner, true);
  }
};

double scale_for(const Polygon& polygon) {
  double farthest_m = 0;
  for (const Vec2 p : polygon.outer) farthest_m = std::max({farthest_m, std::abs(p.x), std::abs(p.y)});
  return farthest_m < 1000 ? 64 : 1;
}

// covers the gap that the strips of two edges leave where the border passes around their corner
void add_corner(Strips& strips, const Ring& ring, std::size_t i, double d0, double d1, std::uint32_t owner) {
  const std::size_t before = (i + ring.size() - 1) % ring.size();
  const Vec2 e0 = direction_of_edge(ring, before), e1 = direction_of_edge(ring, i), v = ring[i];
  if (d0 == 0 || d1 == 0 || !goes_around(e0, e1, d0, d1)) return;
  Ring kite = {v, v + left_of(e0) * d0, v + left_of(e1) * d1};
  const auto corner = moved_corner(e0, e1, d0, d1);
  if (corner && length(*corner) <= kMitreLimit * std::max(std::abs(d0), std::abs(d1)))
    kite.insert(kite.begin() + 2, v + *corner);
  strips.add(kite, owner);
}

void add_strips(Strips& strips, const Polygon& polygon, std::span<const double> depth_m) {
  std::size_t edge = 0;
  for (const Ring* ring : rings_of(polygon)) {
    const std::size_t first = edge, n = ring->size();
    for (std::size_t i = 0; i < n; ++i, ++edge) {
      const Vec2 a = (*ring)[i], b = (*ring)[(i + 1) % n], side = left_of(unit(b - a)) * depth_m[edge];
      const auto owner = static_cast<std::uint32_t>(1 + edge);
      if (depth_m[edge] != 0) strips.add(Ring{a, b, b + side, a + side}, owner);
      add_corner(strips, *ring, i, depth_m[first + (i + n - 1) % n], depth_m[edge], owner);
    }
  }
}

Polygon scaled_back(Polygon polygon, double scale) {
  const auto back = [&](Ring& ring) {
    for (Vec2& p : ring) p = p * (1 / scale);
  };
  back(polygon.outer);
  for (Ring& hole : polygon.holes) back(hole);
  return polygon;
}

std::vector<Polygon> scaled_back(std::vector<Polygon> polygons, double scale) {
  for (Polygon& polygon : polygons) polygon = scaled_back(std::move(polygon), scale);
  return polygons;
}

OffsetPolygon taken_from(std::vector<std::vector<Polygon>> owned, std::size_t edges, double scale) {
  OffsetPolygon offset{{}, {}, true};
  for (std::size_t i = 0; i < edges; ++i) offset.bands.push_back(scaled_back(std::move(owned[1 + i]), scale));
  if (owned.size() > edges + 1) offset.moved = scaled_back(std::move(owned[edges + 1]), scale);
  return offset;
}

// owner 0 covers everything outside the polygon, so no strip gets area there
OffsetPolygon inset_by_strips(const Polygon& polygon, std::span<const double> depth_m) {
  Strips strips{scale_for(polygon), {}};
  const Box2 box = box_of(polygon.outer).widened(1 + *std::max_element(depth_m.begin(), depth_m.end()) * kMitreLimit);
  strips.add(Ring{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}, 0);
  for (const Ring* ring : rings_of(polygon)) strips.add(Ring(ring->rbegin(), ring->rend()), 0, true);
  add_strips(strips, polygon, depth_m);
  const auto edges = static_cast<std::uint32_t>(depth_m.size());
  strips.add(polygon, edges + 1);
  return taken_from(overlay(strips.segments, edges + 2), edges, strips.scale);
}

OffsetPolygon outset_by_strips(const Polygon& polygon, std::span<const double> depth_m) {
  Strips strips{scale_for(polygon), {}};
  strips.add(polygon, 0);
  add_strips(strips, polygon, depth_m);
  const auto edges = static_cast<std::uint32_t>(depth_m.size());
  OffsetPolygon offset = taken_from(overlay(strips.segments, edges + 1), edges, strips.scale);
  // one common owner for polygon and bands
  for (OwnedSegment& segment : strips.segments) segment.owner = 0;
  offset.moved = scaled_back(std::move(overlay(strips.segments, 1).front()), strips.scale);
  return offset;
}

[[maybe_unused]] bool is_depth_per_edge(const Polygon& polygon, std::span<const double> depth_m) {
  std::size_t edges = 0;
  for (const Ring* ring : rings_of(polygon)) edges += ring->size();
  return depth_m.size() == edges && std::ranges::all_of(depth_m, [](double depth) { return depth >= 0; });
}

/// A polygon without zero-length edges and their depths; `from` maps its edges back to the input's.
struct Cleaned {
  Polygon polygon;
  std::vector<double> depth_m;
  std::vector<std::size_t> from;
};

Cleaned cleaned(const Polygon& polygon, std::span<const double> depth_m) {
  Cleaned clean;
  std::size_t edge = 0;
  for (const Ring* ring : rings_of(polygon)) {
    Ring kept;
    for (std::size_t i = 0; i < ring->size(); ++i, ++edge) {
      if (distance((*ring)[i], (*ring)[(i + 1) % ring->size()]) < 0x1p-20) continue;
      kept.push_back((*ring)[i]);
      clean.depth_m.push_back(depth_m[edge]);
      clean.from.push_back(edge);
    }
    (ring == &polygon.outer ? clean.polygon.outer : clean.polygon.holes.emplace_back()) = std::move(kept);
  }
  return clean;
}

OffsetPolygon bands_put_back(OffsetPolygon offset, const Cleaned& clean, std::size_t edges) {
  std::vector<std::vector<Polygon>> bands(edges);
  for (std::size_t i = 0; i < clean.from.size(); ++i) bands[clean.from[i]] = std::move(offset.bands[i]);
  offset.bands = std::move(bands);
  return offset;
}

}  // namespace

OffsetPolygon inset(const Polygon& polygon, std::span<const double> depth_m) {
  assert(is_depth_per_edge(polygon, depth_m));
  const Cleaned clean = cleaned(polygon, depth_m);
  if (clean.polygon.outer.size() < 3) return {{}, std::vector<std::vector<Polygon>>(depth_m.size()), false};
  auto offset = offset_by_corners(clean.polygon, clean.depth_m);
  if (!offset) offset = inset_by_strips(clean.polygon, clean.depth_m);
  return bands_put_back(std::move(*offset), clean, depth_m.size());
}

OffsetPolygon outset(const Polygon& polygon, std::span<const double> depth_m) {
  assert(is_depth_per_edge(polygon, depth_m));
  Cleaned clean = cleaned(polygon, depth_m);
  if (clean.polygon.outer.size() < 3) return {{}, std::vector<std::vector<Polygon>>(depth_m.size()), false};
  for (double& d_m : clean.depth_m) d_m = -d_m;
  auto offset = offset_by_corners(clean.polygon, clean.depth_m);
  if (!offset) offset = outset_by_strips(clean.polygon, clean.depth_m);
  return bands_put_back(std::move(*offset), clean, depth_m.size());
}

}  // namespace citykiln
