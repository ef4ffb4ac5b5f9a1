// Leaves out points of lines that hardly bend there.
#pragma once

#include <span>

#include "compiler/geometry/polygon.h"

namespace citykiln::fields {

/// Returns a line without points that lie within `within_m` of the chord between their neighbours. Its ends stay.
///
/// Each of four rounds drops no two neighbours, so the result is off by up to four times `within_m`. Whether a point is
/// dropped depends on the points about it alone, not on where the line begins. O(n).
Polyline thinned(std::span<const Vec2> line, double within_m);

/// Returns a ring without such points, with at least three.
Ring thinned_ring(std::span<const Vec2> ring, double within_m);

}  // namespace citykiln::fields
