// A circle in space: what tubes and joints are welded by.
#pragma once

#include <array>

#include "compiler/geometry/vec.h"
#include "lsystems/tubes.h"

namespace citykiln::lsystems {

struct Ring {
  Vec3 at, axis{0, 0, 1};  ///< The axis points away from the root.
  Vec3 x{1, 0, 0};         ///< Where the first point lies; square to the axis, of length 1.
  double radius = 0;
  double along_m = 0;  ///< From the root.
  double slope = 0;    ///< How much a metre it narrows; for normals.
  int sides = 4;       ///< 4, 8, … kMostSides.
};

/// Cosine and sine of the kMostSides-th parts of a turn.
using Circle = std::array<Vec2, kMostSides>;
Circle make_circle();

/// From the axis, of length 1, counter-clockwise about it.
inline Vec3 outward(const Ring& ring, Vec3 y, Vec2 turn) { return ring.x * turn.x + y * turn.y; }
inline Vec3 point_on(const Ring& ring, Vec3 outward) { return ring.at + outward * ring.radius; }
inline Vec3 normal_on(const Ring& ring, Vec3 outward) {
  const double scale = 1 / std::sqrt(1 + ring.slope * ring.slope);
  return (outward + ring.axis * ring.slope) * scale;
}

/// v, made square to an axis of length 1, of length 1; some such direction where v is along the axis.
Vec3 perpendicular_to(Vec3 axis, Vec3 v);

/// x, square to `from`, turned with it to `to` the shortest way.
Vec3 parallel_transported(Vec3 x, Vec3 from, Vec3 to);

/// How far the chords of a circle lie inside of it, in radii.
double sagitta(int sides);

/// The fewest sides whose sagitta is at most `tolerance_m`; at most kMostSides.
int sides_of(double radius, double tolerance_m);

}  // namespace citykiln::lsystems
