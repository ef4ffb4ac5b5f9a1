// Splits edges of a primitive that are longer than a limit.
#pragma once

#include "compiler/bake/baked_tile.h"

namespace citykiln::bake {

/// Halves every edge that is longer than `longest_m` until none is, and divides the triangles. Whether and where an
/// edge is halved depends on its ends only, so primitives that share an edge still share it afterwards. A new vertex is
/// the mean of the edge's ends, exact if these are multiples of kQuantum_m (2^-10 m).
/// @param longest_m  > 0.
/// O(triangles after).
void split_long_edges(Primitive& primitive, double longest_m);

}  // namespace citykiln::bake
