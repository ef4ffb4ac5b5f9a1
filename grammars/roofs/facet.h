// Facets: pieces of a roof's plan over which the roof is planar, with the plane of each.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/geometry/polygon.h"

namespace citykiln::roofs {

/// An affine function of the position in plan: at(p) = dot(gradient, p - origin) + offset. An origin near p keeps
/// precision.
struct Plane {
  Vec2 origin, gradient;
  double offset = 0;
  double at(Vec2 p) const { return dot(gradient, p - origin) + offset; }
};

/// Returns the affine function first · a(p) + second · b(p).
Plane combined(double first, const Plane& a, double second, const Plane& b);

/// A piece of the plan over which the roof is planar.
struct Facet {
  Ring ring;    ///< Counter-clockwise.
  Plane plane;  ///< Its value is metres over the eaves plane; in InsetFacets, metres inward from the eaves.
  /// Facets with equal numbers meet in height; between facets with different numbers there may be a wall.
  std::uint32_t surface = 0;
  std::uint32_t face = 0;  ///< Facets with equal numbers are in one plane, such as the roof plane over one edge.
};

/// Returns the part of a convex ring where plane.at() >= 0, counter-clockwise or empty. Source: Sutherland and Hodgman
/// 1974.
Ring clipped(std::span<const Vec2> ring, const Plane& plane);

/// Returns the parts of a simple ring where plane.at() >= 0, one ring for each connected part. O(n log n).
std::vector<Ring> clipped_pieces(const Ring& ring, const Plane& plane);

/// Returns the signed distance from the line through a and b, positive to the left of the line.
///
/// @param b  Differs from a.
Plane distance_left_of(Vec2 a, Vec2 b);

}  // namespace citykiln::roofs
