// Moves the vertices of a tile onto the grids of packed meshes, and adds the distance to its stated error.
#pragma once

#include <span>

#include "compiler/bake/baked_tile.h"
#include "compiler/contract/system/compression.h"

namespace citykiln::exporters {

/// Returns an upper bound of the distance by which single precision has moved a position: half of the last bit along
/// each axis. Ignores coordinates on the grid of kQuantum_m, such as coordinates of the ground, which are exact.
double rounding_m(std::span<const bake::Primitive> primitives);

/// Returns the tile on the grids of packed meshes (packed_grids.h); with kLean only its uvs. object_error_m grows by
/// the longest move of a position, at most half a step times √3 and the scale of its instance, and by rounding_m();
/// error_m is at least that. plant_error_m grows by the longest move in plants.
///
/// - Positions of ground, roads and water stay: they are on the grid of kQuantum_m. Others become multiples of
///   packed_position_step_m(); of prototypes, of kPrototypeStepRatio of it.
/// - uvs on images become multiples of the largest power of two that is at most a texel / kUvStepsPerTexel.
/// - uvs on textures are moved by whole periods, object by object, so that they begin in the first one,
///   and become multiples of packed_texture_step_m().
/// - Vertices that have become equal are shared (share_vertices.h). Triangles that then use a vertex twice are dropped,
///   but none if the primitive would lose all.
///
/// Guarantees: equal positions stay equal, also between tiles or levels with the same step, so borders meet. Quantising
/// twice changes nothing more. Accepts any tile. O(n).
/// @param compression  Not kNone.
bake::BakedTile quantised(bake::BakedTile tile, Compression compression);

/// Returns a bound of what quantised() adds to error_m, known before a tile is baked. 0 with kNone and kLean.
/// @param reach_m        A bound of coordinates from the tile's origin.
/// @param largest_scale  The largest scale of an instance that is no plant.
double quantising_bound_m(double tolerance_m, double reach_m, double largest_scale, Compression compression);

}  // namespace citykiln::exporters
