// Finds the distance from a place to the nearest of many strips, each the places within a distance of a segment.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/polygon.h"
#include "compiler/geometry/vec.h"

namespace citykiln::lots {

/// The places within half_m of the segment from a to b.
struct Capsule {
  Vec2 a, b;
  double half_m = 0;
};

/// Capsules with a spatial index.
struct Capsules {
  std::vector<Capsule> all;
  BoxGrid grid;
};

/// Returns the index of capsules. O(n).
Capsules index_capsules(std::vector<Capsule> all);

/// Returns the distance from p to the nearest capsule, negative inside of one; search_m if none is nearer.
/// O(capsules near).
double clearance_m(const Capsules& capsules, Vec2 p, double search_m);

/// True if one of five places along the segment of a capsule, its ends included, lies in the polygon. O(capsules near).
bool reaches_into(const Capsules& capsules, const Polygon& polygon);

}  // namespace citykiln::lots
