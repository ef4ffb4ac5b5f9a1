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

// The corner that a bend opens between two quads, filled to the mitre: p, the two outer corners and the point where the
// outer edges meet.
Ring mitre(Vec2 p, Vec2 before, Vec2 after, double half_m) {
  const double side = cross(before, after) > 0 ? -1 : 1;  // a left bend opens on the right
  const Vec2 a = left_of(before) * (side * half_m), b = left_of(after) * (side * half_m);
  const Vec2 tip = (a + b) * (half_m * half_m / (half_m * half_m + dot(a, b)));
  return {snapped(p), snapped(p + a), snapped(p + tip), snapped(p + b)};
}

// Bends of less than a right angle take a mitre (its tip lies within 1.42 half widths), sharper ones a disk.
Ring bend(Vec2 p, Vec2 before, Vec2 after, double half_m) {
  return dot(before, after) > 0 ? mitre(p, before, after, half_m) : disk(p, half_m);
}

// Turned counter-clockwise; what snapping left without area is no ring.
void push_if_area(std::vector<Ring>& rings, Ring ring) {
  ring = without_repeats(ring);
  if (ring.size() < 3) return;
  const double area = signed_area_m2(ring);
  if (area < 0) std::reverse(ring.begin(), ring.end());
  if (area != 0) rings.push_back(std::move(ring));
}

}  // namespace

std::vector<Ring> stroke(const Road& road) {
  std::vector<Ring> rings;
  const double half_m = road.width_m / 2;
  const auto direction = [&](std::size_t i) { return unit(road.axis[i + 1] - road.axis[i]); };
  for (std::size_t i = 0; i + 1 < road.axis.size(); ++i) {
    const Vec2 a = road.axis[i], b = road.axis[i + 1], off = left_of(direction(i)) * half_m;
    push_if_area(rings, {snapped(a - off), snapped(b - off), snapped(b + off), snapped(a + off)});
    if (i > 0) push_if_area(rings, bend(a, direction(i - 1), direction(i), half_m));
  }
  if (road.rounds_start) push_if_area(rings, disk(road.axis.front(), half_m));
  if (road.rounds_end) push_if_area(rings, disk(road.axis.back(), half_m));
  return rings;
}

}  // namespace citykiln::roads
