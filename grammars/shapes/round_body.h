// Round bodies as closed polyhedra: cylinders, cones, spheres and domes that fill a scope, with the distance between
// the polyhedron and the exact body.
//
//      ___
//    /     \      The corners of the polygon lie outside of the circle by as much as the middles of its sides lie
//   |   ·   |     inside, which is half the error of an inscribed polygon.
//    \ ___ /
#pragma once

#include <vector>

#include "grammars/shapes/scope.h"

namespace citykiln::grammars {

/// A closed surface, and its Hausdorff distance from the exact body.
struct RoundBody {
  std::vector<Face> faces;  ///< Planar, counter-clockwise seen from outside, sharing their corners bit for bit.
  double deviation_m = 0;   ///< At most this; 0 for bodies with a given number of sides, which are exact.
};

/// The way in which a round body is divided into faces.
struct RoundSides {
  int given = 0;      ///< The number of sides; 0: as many as the allowed deviation needs.
  double most_m = 0;  ///< The allowed deviation, where `given` is 0.
  static constexpr int kLeast = 3, kMost = 256;
};

/// Returns the number of sides of a regular polygon that is within `most_m` of a circle of this radius, at most
/// RoundSides::kMost; one of 17 numbers, so that few different bodies occur.
int sides_for(double radius_m, double most_m);

/// Returns the cylinder, or the frustum of a cone, that fills the scope, in plane metres.
///
/// @param axis  The index of the scope's axis along which it stands: 0, 1 or 2.
/// @param top   The radius at the far end as a share of the one at the near end, 0 … 1; 0: a cone with an apex.
///
/// Guarantees: closed; uses no function of libm other than the square root. With given sides, the polygon fills the
/// scope's rectangle, so that one of four sides is the scope's box. O(sides).
RoundBody cylinder_in(const Scope& scope, int axis, double top, RoundSides sides);

/// Returns the ellipsoid that fills the scope. It has at least 4 sides. With given sides, corners lie on the ellipsoid,
/// so the body touches the scope only at its poles and where a corner faces a side. Closed; uses no function of libm
/// other than the square root. O(sides²).
RoundBody sphere_in(const Scope& scope, int axis, RoundSides sides);

/// Returns the half of an ellipsoid that stands on the near end of the scope along `axis` and fills the scope. It has
/// at least 4 sides; with given sides, corners lie on the ellipsoid. Closed; uses no function of libm other than the
/// square root. O(sides²).
RoundBody dome_in(const Scope& scope, int axis, RoundSides sides);

}  // namespace citykiln::grammars
