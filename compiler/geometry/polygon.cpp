#include "compiler/geometry/polygon.h"

#include <algorithm>
#include <cstdint>

namespace citykiln {
namespace {

enum Side : unsigned { kLeft = 1, kRight = 2, kBelow = 4, kAbove = 8 };

// The sides of the box beyond which the point lies, as bits of Side.
unsigned outside(Vec2 p, const Box2& box) {
  return (p.x < box.min.x ? kLeft : 0u) | (p.x > box.max.x ? kRight : 0u) | (p.y < box.min.y ? kBelow : 0u) |
         (p.y > box.max.y ? kAbove : 0u);
}

}  // namespace

std::vector<const Ring*> rings_of(const Polygon& polygon) {
  std::vector<const Ring*> rings = {&polygon.outer};
  for (const Ring& hole : polygon.holes) rings.push_back(&hole);
  return rings;
}

double signed_area_m2(std::span<const Vec2> ring) {
  if (ring.size() < 3) return 0;
  // relative to the first point, to keep digits far from the origin
  double twice = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) twice += cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
  return twice / 2;
}

double area_m2(const Polygon& polygon) {
  double area = signed_area_m2(polygon.outer);
  for (const Ring& hole : polygon.holes) area += signed_area_m2(hole);
  return area;
}

double length_m(std::span<const Vec2> polyline) {
  double sum = 0;
  for (std::size_t i = 1; i < polyline.size(); ++i) sum += distance(polyline[i - 1], polyline[i]);
  return sum;
}

int winding_number(std::span<const Vec2> ring, Vec2 p) {
  int winding = 0;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const Vec2 a = ring[j], b = ring[i];
    if ((a.y <= p.y) == (b.y <= p.y)) continue;
    const double side = cross(b - a, p - a);
    if (a.y <= p.y && side > 0) ++winding;
    if (b.y <= p.y && side < 0) --winding;
  }
  return winding;
}

bool contains(const Polygon& polygon, Vec2 p) {
  bool inside = winding_number(polygon.outer, p) % 2 != 0;
  for (const Ring& hole : polygon.holes) inside ^= winding_number(hole, p) % 2 != 0;
  return inside;
}

Ring without_repeats(std::span<const Vec2> ring) {
  Ring kept;
  const auto folds = [](Vec2 a, Vec2 b, Vec2 c) { return cross(b - a, c - b) == 0 && dot(b - a, c - b) < 0; };
  const auto push = [&](Vec2 p) {
    while (kept.size() >= 2 && folds(kept[kept.size() - 2], kept.back(), p)) kept.pop_back();
    if (kept.empty() || kept.back() != p) kept.push_back(p);
  };
  for (const Vec2 p : ring) push(p);
  // repeats across the seam between last and first point until nothing changes
  for (bool changed = true; changed && kept.size() >= 3;) {
    changed = true;
    const std::size_t n = kept.size();
    if (kept.back() == kept.front() || folds(kept[n - 2], kept[n - 1], kept[0]))
      kept.pop_back();
    else if (folds(kept[n - 1], kept[0], kept[1]))
      kept.erase(kept.begin());
    else
      changed = false;
  }
  return kept;
}

Ring trimmed_to(std::span<const Vec2> ring, const Box2& box) {
  if (ring.empty() || !box_of(ring).touches(box)) return {};
  // a vertex is dropped if it, its kept predecessor and its successor all lie beyond one common side: the path between
  // them stays beyond that side
  Ring kept = {ring[0]};
  for (std::size_t i = 1; i < ring.size(); ++i) {
    const Vec2 before = kept.back();
    const Vec2 after = ring[(i + 1) % ring.size()];
    if ((outside(before, box) & outside(ring[i], box) & outside(after, box)) == 0) kept.push_back(ring[i]);
  }
  return kept.size() < 3 ? Ring{} : kept;
}

}  // namespace citykiln
