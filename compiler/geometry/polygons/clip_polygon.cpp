#include "compiler/geometry/polygons/clip_polygon.h"

#include <cassert>
#include <cmath>

#include "compiler/geometry/polygons/overlay.h"

namespace citykiln {
namespace {

constexpr double kBorderStep_m = 128;

// Appends the points from a to b, without b, with one at each multiple of kBorderStep_m; a and b differ in one
// coordinate.
void add_side(Ring& ring, Vec2 a, Vec2 b) {
  const bool is_level = a.y == b.y;
  const double from = is_level ? a.x : a.y, to = is_level ? b.x : b.y, sign = to > from ? 1 : -1;
  ring.push_back(a);
  for (double at = std::floor(sign * from / kBorderStep_m + 1) * kBorderStep_m; at < sign * to; at += kBorderStep_m)
    ring.push_back(is_level ? Vec2{sign * at, a.y} : Vec2{a.x, sign * at});
}

Ring ring_of_box(const Box2& box) {
  const Vec2 corners[] = {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
  Ring ring;
  for (std::size_t i = 0; i < 4; ++i) add_side(ring, corners[i], corners[(i + 1) % 4]);
  return ring;
}

}  // namespace

std::vector<Polygon> united(std::span<const Ring> rings) {
  std::vector<OwnedSegment> segments;
  for (const Ring& ring : rings) add_ring(segments, ring, 0);
  return std::move(overlay(segments, 1).front());
}

std::vector<Polygon> united_in(std::span<const Ring> rings, const Box2& box) {
  assert(box.width() > 0 && box.height() > 0);
  // what lies outside of the box belongs to an owner on top
  constexpr std::uint32_t kOutside = 0, kInside = 1;
  std::vector<OwnedSegment> segments;
  Box2 around = box;
  for (const Ring& ring : rings) {
    if (ring.empty() || !box_of(ring).touches(box)) continue;
    add_ring(segments, ring, kInside);
    for (const Vec2 p : ring) around.grow(p);
  }
  if (segments.empty()) return {};
  if (around != box) {
    Ring hole = ring_of_box(box);
    std::ranges::reverse(hole);
    add_ring(segments, hole, kOutside);
    add_ring(segments, ring_of_box(around.widened(1)), kOutside);
  }
  return std::move(overlay(segments, 2)[kInside]);
}

std::vector<Ring> copied_rings(const Polygon& polygon) {
  std::vector<Ring> rings = {polygon.outer};
  rings.insert(rings.end(), polygon.holes.begin(), polygon.holes.end());
  return rings;
}

}  // namespace citykiln
