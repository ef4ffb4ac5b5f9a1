#include "compiler/buildings/meshes/passageways.h"

#include <algorithm>

#include "compiler/geometry/segment.h"
#include "compiler/roads/generate.h"

namespace citykiln::buildings {
namespace {

// The part of the line inside a convex ring.
LinePart stretch_in(const Ring& ring, Vec2 a, Vec2 along, double length_m) {
  LinePart stretch{0, length_m};
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 p = ring[i], side = ring[(i + 1) % ring.size()] - p;
    // how far inside the line begins, and how fast it goes further inside
    const double depth = cross(side, a - p), rise = cross(side, along);
    if (rise > 0) stretch.from_m = std::max(stretch.from_m, -depth / rise);
    if (rise < 0) stretch.to_m = std::min(stretch.to_m, -depth / rise);
    if (rise == 0 && depth <= 0) return {};
  }
  return stretch;
}

std::vector<LinePart> merged(std::vector<LinePart> stretches) {
  std::ranges::sort(stretches, {}, &LinePart::from_m);
  std::vector<LinePart> all;
  for (const LinePart& stretch : stretches)
    if (!all.empty() && stretch.from_m <= all.back().to_m)
      all.back().to_m = std::max(all.back().to_m, stretch.to_m);
    else
      all.push_back(stretch);
  return all;
}

}  // namespace

std::vector<Ring> opening_rings(const Passageway& passageway) {
  return roads::stroke(
      {.id = passageway.way, .axis = passageway.axis, .left_m = passageway.left_m, .right_m = passageway.right_m});
}

std::vector<LinePart> parts_in_openings(const Building& building, Vec2 a, Vec2 b, double least_m) {
  const double length_m = distance(a, b);
  if (building.passageways.empty() || length_m == 0) return {};
  std::vector<LinePart> stretches;
  for (const Passageway& passageway : building.passageways)
    for (const Ring& ring : opening_rings(passageway)) {
      LinePart stretch = stretch_in(ring, a, (b - a) * (1 / length_m), length_m);
      if (stretch.to_m - stretch.from_m < least_m) continue;
      if (stretch.from_m < least_m) stretch.from_m = 0;
      if (stretch.to_m > length_m - least_m) stretch.to_m = length_m;
      stretches.push_back(stretch);
    }
  return merged(std::move(stretches));
}

bool is_in_opening(const Building& building, Vec2 p) {
  constexpr double kOnSide_m = 0x1p-9;
  return std::ranges::any_of(building.passageways, [&](const Passageway& passageway) {
    return std::ranges::any_of(opening_rings(passageway), [&](const Ring& ring) {
      return contains({ring, {}}, p) || distance_to_ring(ring, p) <= kOnSide_m;
    });
  });
}

}  // namespace citykiln::buildings
