// Joins several baked tiles of one tolerance to one tile, to have a whole map in one file.
#pragma once

#include <span>

#include "compiler/bake/baked_tile.h"
#include "compiler/contract/result.h"

namespace citykiln::commands {

/// What to do with tiles over more than 16 km, where multiples of 2^-10 m are no longer exact in single precision.
enum class JoinPrecision {
  kExact,   ///< They are an error.
  kRounded  ///< Positions are rounded, by up to 2^-24 of their distance from the origin; error_m grows by that.
};

/// Guarantees: triangles and instances keep their places; one primitive for each key; each shows the texels of
/// its own tile's atlases, which are joined (join_marking_atlases.h, join_facade_atlases.h); the error is the largest
/// of all.
/// @param tiles  At least one. The joined tile has the name of the first; its origin is the lowest corner of all.
/// Errors: tiles over more than 16 km unless they may be rounded; marking atlases that cannot be joined.
/// O(vertices).
Result<bake::BakedTile> join_tiles(std::span<const bake::BakedTile> tiles,
                                   JoinPrecision precision = JoinPrecision::kExact);

}  // namespace citykiln::commands
