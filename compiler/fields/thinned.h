// Leaves out points where a line hardly bends.
#pragma once

#include <span>

#include "compiler/geometry/polygon.h"

namespace citykiln::fields {

/// Returns a line without most of the points that are nearer than `within_m`, in metres, to the
/// chord between their neighbours. Its ends stay.
///
/// Each of four rounds drops points of which no two are neighbours, so the result is off the line
/// by less than four times `within_m`. Points that only more rounds would drop stay. The decision
/// about a point depends only on the points near it, not on where the line begins. The result may
/// cross itself. O(n).
Polyline thinned(std::span<const Vec2> line, double within_m);

/// Returns a ring without such points. A ring of three or four points stays, and a larger one keeps
/// at least three.
Ring thinned_ring(std::span<const Vec2> ring, double within_m);

}  // namespace citykiln::fields
