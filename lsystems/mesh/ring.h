// Rings: circles in space where tubes and joints meet.
#pragma once

#include <array>

#include "compiler/geometry/vec.h"
#include "lsystems/mesh/tubes.h"

namespace citykiln::lsystems {

/// A circle around a stem, at whose points tubes and joints meet.
struct Ring {
  Vec3 at, axis{0, 0, 1};  ///< The centre, and the axis: a unit vector away from the root.
  Vec3 x{1, 0, 0};         ///< The direction of the first point: a unit vector perpendicular to the axis.
  double radius = 0;
  double along_m = 0;  ///< The distance from the root along the stems.
  double slope = 0;    ///< The decrease of the radius per metre, for normals.
  int sides = 4;       ///< 4, 8, … kMostSides.
};

/// The cosine and sine of multiples of 1 / kMostSides turns.
using Circle = std::array<Vec2, kMostSides>;
/// Returns the table of cosines and sines.
Circle make_circle();

/// Returns the unit direction from the axis at a turn about it, counter-clockwise.
///
/// @param y     The cross product of the ring's axis and ring.x.
/// @param turn  {cosine, sine}.
inline Vec3 outward(const Ring& ring, Vec3 y, Vec2 turn) { return ring.x * turn.x + y * turn.y; }
/// Returns the point of the ring in a direction from its axis.
/// @param outward  A result of outward().
inline Vec3 point_on(const Ring& ring, Vec3 outward) { return ring.at + outward * ring.radius; }
/// Returns the unit normal of the stem's surface in a direction from the axis of the ring.
/// @param outward  A result of outward().
inline Vec3 normal_on(const Ring& ring, Vec3 outward) {
  const double scale = 1 / std::sqrt(1 + ring.slope * ring.slope);
  return (outward + ring.axis * ring.slope) * scale;
}

/// Returns the direction of v's component perpendicular to a unit axis; any perpendicular if v is parallel to the axis.
Vec3 perpendicular_to(Vec3 axis, Vec3 v);

/// Returns x, which is perpendicular to `from`, after the shortest rotation from `from` to `to`.
Vec3 parallel_transported(Vec3 x, Vec3 from, Vec3 to);

/// Returns the distance between a chord's midpoint and the circle, in radii.
double sagitta(int sides);

/// Returns the fewest sides, 4, 8, … kMostSides, whose sagitta is within the tolerance; else kMostSides.
int sides_of(double radius, double tolerance_m);

}  // namespace citykiln::lsystems
