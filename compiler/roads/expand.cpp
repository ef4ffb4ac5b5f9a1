#include "compiler/roads/expand.h"

#include <algorithm>
#include <array>

#include "compiler/geometry/snap.h"

namespace citykiln::roads {
namespace {

// cos and sin of k · 22.5°, written out so that every CPU agrees.
constexpr double kC1 = 0.9238795325112867, kC2 = 0.7071067811865476, kC3 = 0.3826834323650898;
constexpr std::array<Vec2, 16> kCircle = {{{1, 0},
                                           {kC1, kC3},
                                           {kC2, kC2},
                                           {kC3, kC1},
                                           {0, 1},
                                           {-kC3, kC1},
                                           {-kC2, kC2},
                                           {-kC1, kC3},
                                           {-1, 0},
                                           {-kC1, -kC3},
                                           {-kC2, -kC2},
                                           {-kC3, -kC1},
                                           {0, -1},
                                           {kC3, -kC1},
                                           {kC2, -kC2},
                                           {kC1, -kC3}}};

Ring disk(Vec2 centre, double radius_m) {
  Ring ring;
  for (const Vec2 direction : kCircle) ring.push_back(snapped(centre + direction * radius_m));
  return ring;
}

// How far a strip reaches to either side of its axis.
struct Halves {
  double left_m, right_m;
};

// The corner that a bend opens between two quads, filled to the mitre: p, the two outer corners and the point where the
// outer edges meet.
Ring mitre(Vec2 p, Vec2 before, Vec2 after, Halves halves) {
  // a left bend opens on the right
  const double half_m = cross(before, after) > 0 ? -halves.right_m : halves.left_m;
  const Vec2 a = left_of(before) * half_m, b = left_of(after) * half_m;
  const Vec2 tip = (a + b) * (1 / (1 + dot(before, after)));
  return {snapped(p), snapped(p + a), snapped(p + tip), snapped(p + b)};
}

// Bends of less than a right angle take a mitre (its tip lies within 1.42 half widths), sharper ones a disk.
Ring bend(Vec2 p, Vec2 before, Vec2 after, Halves halves) {
  return dot(before, after) > 0 ? mitre(p, before, after, halves) : disk(p, std::max(halves.left_m, halves.right_m));
}

// Turned counter-clockwise; what snapping left without area is no ring.
void push_if_area(std::vector<Ring>& rings, Ring ring) {
  ring = without_repeats(ring);
  if (ring.size() < 3) return;
  const double area = signed_area_m2(ring);
  if (area < 0) std::reverse(ring.begin(), ring.end());
  if (area != 0) rings.push_back(std::move(ring));
}

std::vector<Ring> stroke_along(const Polyline& axis, Halves halves) {
  std::vector<Ring> rings;
  const auto direction = [&](std::size_t i) { return unit(axis[i + 1] - axis[i]); };
  for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
    const Vec2 a = axis[i], b = axis[i + 1], left = left_of(direction(i)) * halves.left_m;
    const Vec2 right = left_of(direction(i)) * -halves.right_m;
    push_if_area(rings, {snapped(a + right), snapped(b + right), snapped(b + left), snapped(a + left)});
    if (i > 0) push_if_area(rings, bend(a, direction(i - 1), direction(i), halves));
  }
  return rings;
}

}  // namespace

std::vector<Ring> stroke(const Road& road) {
  const double half_m = road.width_m / 2;
  std::vector<Ring> rings = stroke_along(road.axis, {half_m, half_m});
  if (road.rounds_start) push_if_area(rings, disk(road.axis.front(), half_m));
  if (road.rounds_end) push_if_area(rings, disk(road.axis.back(), half_m));
  return rings;
}

std::vector<Ring> stroke_pavements(const Road& road) {
  if (road.pavement_left_m == 0 && road.pavement_right_m == 0) return {};
  const double half_m = road.width_m / 2;
  return stroke_along(road.axis, {half_m + road.pavement_left_m, half_m + road.pavement_right_m});
}

}  // namespace citykiln::roads
