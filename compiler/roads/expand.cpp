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

// Sharper bends are ends, not joints.
bool is_joint(Vec2 before, Vec2 after) { return dot(before, after) > 0; }

std::vector<Ring> stroke_along(const Polyline& axis, Halves halves, const Ends& ends) {
  std::vector<Ring> rings;
  const auto direction = [&](std::size_t i) { return unit(axis[i + 1] - axis[i]); };
  for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
    const Vec2 a = axis[i], b = axis[i + 1], left = left_of(direction(i)) * halves.left_m;
    const Vec2 right = left_of(direction(i)) * -halves.right_m;
    push_if_area(rings, {snapped(a + right), snapped(b + right), snapped(b + left), snapped(a + left)});
    if (i > 0) push_if_area(rings, bend(a, direction(i - 1), direction(i), halves));
  }
  const auto join = [&](Vec2 at, Vec2 before, Vec2 after) {
    if (is_joint(before, after)) push_if_area(rings, mitre(at, before, after, halves));
  };
  if (ends.from) join(axis.front(), unit(axis.front() - *ends.from), direction(0));
  if (ends.to) join(axis.back(), direction(axis.size() - 2), unit(*ends.to - axis.back()));
  return rings;
}

}  // namespace

std::vector<Ring> stroke(const Strip& strip, const Ends& ends) {
  std::vector<Ring> rings = stroke_along(strip.axis, {strip.left_m, strip.right_m}, ends);
  if (!ends.are_round) return rings;
  for (const Vec2 end : {strip.axis.front(), strip.axis.back()})
    push_if_area(rings, disk(end, (strip.left_m + strip.right_m) / 2));
  return rings;
}

std::vector<Ring> stroke_pavements(const Road& road, const Ends& ends) {
  const double left = raised_left_m(road), right = raised_right_m(road);
  if (left == 0 && right == 0) return {};
  return stroke_along(road.axis, {left_m(road) + left, right_m(road) + right}, ends);
}

}  // namespace citykiln::roads
