// A tile on the grids of packed meshes: what a compressed .glb loses is lost here, and stated.
#pragma once

#include <span>

#include "compiler/bake/baked_tile.h"

namespace citykiln::exporters {

/// How far single precision may have moved a place at most: nothing where it is on the grid of kQuantum_m, as the
/// ground is, half a last bit in each direction elsewhere, as on walls.
double rounding_m(std::span<const bake::Primitive> primitives);

/// The tile with all places on the grid of kPackedPosition_m, and uvs on that of kPackedUv_m; error_m is larger by the
/// farthest that any place has moved, in the world: at most half a step times √3 (for copies: and their scale), and by
/// the rounding before.
///
/// Guarantees: places that are on the grid stay, so borders, which are, meet as before; equal places stay equal; no
/// triangle goes, even where its corners meet; quantised twice is quantised once. Total. O(n).
bake::BakedTile quantised(bake::BakedTile tile);

}  // namespace citykiln::exporters
