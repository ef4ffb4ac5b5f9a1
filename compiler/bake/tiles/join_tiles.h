// Joins several baked tiles of one tolerance to one tile, so that a whole map is in one file.
#pragma once

#include <span>

#include "compiler/bake/baked_tile.h"
#include "compiler/contract/result.h"

namespace citykiln::bake {

/// Treatment of tiles that extend over more than 16 km, where single precision no longer holds multiples of 2^-10 m
/// exactly.
enum class JoinPrecision {
  kExact,   ///< join_tiles() returns an error.
  kRounded  ///< Positions are rounded, by up to 2^-24 of their distance from the origin; error_m grows by that.
};

/// Joins tiles. The triangles of each PrimitiveKey (layer, material, whether there are uvs, source of colours) become
/// one primitive. Each part shows the texels of its own tile's atlases, which are joined (join_marking_atlases.h,
/// join_facade_atlases.h). The joined tile has the name of the first tile; its origin is the lowest corner of all
/// origins. Its error is the largest of all tiles, plus rounding.
///
/// @param tiles  At least one.
///
/// Guarantees: triangles and instances keep their places, up to rounding. Skirts between the tiles stay
/// (remove_inner_skirts() of simplify_tile.h removes them). Errors: tiles over more than 16 km unless rounding is
/// allowed; marking atlases that cannot be joined. O(vertices).
Result<BakedTile> join_tiles(std::span<const BakedTile> tiles, JoinPrecision precision = JoinPrecision::kExact);

}  // namespace citykiln::bake
