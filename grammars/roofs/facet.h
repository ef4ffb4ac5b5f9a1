// Flat pieces of a roof, seen from above.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/geometry/polygon.h"

namespace citykiln::roofs {

/// A linear function of the place: at(p) = gradient · (p - origin) + offset. `origin` near p keeps its digits.
struct Plane {
  Vec2 origin, gradient;
  double offset = 0;
  double at(Vec2 p) const { return dot(gradient, p - origin) + offset; }
};

/// first · a + second · b.
Plane combined(double first, const Plane& a, double second, const Plane& b);

/// A piece of the plan over which the roof is flat.
struct Facet {
  Ring ring;                ///< Counter-clockwise.
  Plane plane;              ///< Metres over the eaves plane; or, in a base, metres from the eaves in plan.
  std::uint32_t sheet = 0;  ///< Facets of one sheet fit together; between two sheets the roof may step.
  std::uint32_t face = 0;   ///< Facets of one face lie in one plane: the roof's side over one edge, say.
};

/// The part of a convex ring where plane.at() >= 0: counter-clockwise, or empty. Source: Sutherland and Hodgman 1974.
Ring clipped(std::span<const Vec2> ring, const Plane& plane);

/// The same of any simple ring, in as many pieces as it falls into. O(n log n).
std::vector<Ring> clipped_pieces(const Ring& ring, const Plane& plane);

/// The plane that is 0 on the line through a and b, and grows to its left by 1 a metre.
Plane distance_left_of(Vec2 a, Vec2 b);

}  // namespace citykiln::roofs
