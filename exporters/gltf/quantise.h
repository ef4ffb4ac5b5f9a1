// Moves a tile onto the grids of packed meshes, and adds what that changes to its stated error.
#pragma once

#include <span>

#include "compiler/bake/baked_tile.h"

namespace citykiln::exporters {

/// An upper bound of how far single precision has moved a position: 0 where all are on the grid of kQuantum_m, as the
/// ground is; elsewhere, as on walls, half of the last bit in each direction.
double rounding_m(std::span<const bake::Primitive> primitives);

/// Returns the tile on the grids of packed meshes (packed_grids.h). error_m grows by the longest move of a position, at
/// most half a step times √3, and by rounding_m(); plant_error_m by that of instances, times their scale.
///
/// - Positions of ground, roads and water stay: they are on the grid of kQuantum_m. Others become multiples of
///   packed_position_step_m(); of prototypes, of kPrototypeStepRatio of it.
/// - uvs on images become multiples of the largest power of two that is at most a texel / kUvStepsPerTexel.
/// - uvs on textures are moved by whole periods, object by object, so that they begin in the first one,
///   and become multiples of packed_texture_step_m().
/// - Vertices that have become equal are shared (share_vertices.h); triangles without an area go.
///
/// Guarantees: equal positions stay equal, those of two tiles or levels with one step too, so that borders meet;
/// quantising twice changes nothing more. Total. O(n).
bake::BakedTile quantised(bake::BakedTile tile);

}  // namespace citykiln::exporters
