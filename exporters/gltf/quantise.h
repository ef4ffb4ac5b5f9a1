// Moves a tile onto the grids of packed meshes, and adds what that changes to its stated error.
#pragma once

#include <span>

#include "compiler/bake/baked_tile.h"

namespace citykiln::exporters {

/// An upper bound of how far single precision has moved a position: 0 where all are on the grid of kQuantum_m, as the
/// ground is; elsewhere, as on walls, half of the last bit in each direction.
double rounding_m(std::span<const bake::Primitive> primitives);

/// Returns the tile with positions on the grid of kPackedPosition_m and uvs on that of kPackedUv_m. error_m grows by
/// the longest move of a position, at most half a step times √3 (times the scale for instances), and by rounding_m().
///
/// Guarantees: positions on the grid stay, so that borders, which are on it, meet as before; equal positions stay
/// equal; every triangle is kept, even where its corners coincide; quantising twice changes nothing more. Total. O(n).
bake::BakedTile quantised(bake::BakedTile tile);

}  // namespace citykiln::exporters
