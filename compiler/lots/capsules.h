// Finds the distance from a place to the nearest of many strips, each the places within a distance of a segment.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/polygon.h"
#include "compiler/geometry/vec.h"

namespace citykiln::lots {

/// The places within radius_m of the segment from a to b, its axis.
struct Capsule {
  Vec2 a, b;
  double radius_m = 0;
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

/// True if the axis of a capsule enters the polygon, tested at five places, its ends included. The radius does not
/// count. O(capsules near).
bool axis_enters(const Capsules& capsules, const Polygon& polygon);

}  // namespace citykiln::lots
