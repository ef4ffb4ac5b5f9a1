// Splits edges of a primitive that are too long.
#pragma once

#include <functional>

#include "compiler/bake/baked_tile.h"

namespace citykiln::bake {

/// Returns true if an edge is too long.
///
/// @param along  The vector between its ends, in either direction.
using IsLong = std::function<bool(Vec3 along)>;

/// Halves every edge that is too long until none is, and divides the triangles. Whether and where an edge is halved
/// depends on its ends only, so primitives that share an edge still share it afterwards. A new vertex is the mean of
/// the edge's ends, exact if these are multiples of kQuantum_m (2^-10 m).
/// @param is_long  Must be false for short edges in all directions, and equal for a vector and its opposite.
/// O(triangles after).
void split_long_edges(Primitive& primitive, const IsLong& is_long);

}  // namespace citykiln::bake
