// Back sides of leaves: cards on cutouts are seen from both sides, and have one normal for both.
//
// A doubleSided material flips the normal of a face that is seen from behind. Normals of leaves point out of the crown,
// so flipped ones would point into it, and the leaf would be black. A second face of the same vertices with reversed
// winding is right in all programs that leave out faces seen from behind.
#pragma once

#include <cstddef>

#include "compiler/bake/baked_tile.h"

namespace citykiln::exporters {

/// The number of triangles above which a primitive has no back sides and is doubleSided instead: trees in near views,
/// of which twice as many triangles would be slow.
inline constexpr std::size_t kMostTrianglesWithBacks = 2000;

/// True if a primitive is written with back sides, for programs that leave out faces seen from behind: cards on a
/// cutout, at most kMostTrianglesWithBacks.
bool has_backs(const bake::Primitive& p);

/// Appends back sides: each triangle with reversed winding, of the same vertices.
bake::Primitive with_backs(bake::Primitive p);

/// Removes back sides: of two triangles with the same corners and opposite windings, the first stays, which in packed
/// files can be either. Corners are the same if they have the same place and uv, since codecs may divide vertices.
/// without_backs(with_backs(p)) == p for a primitive without back sides. O(n log n).
bake::Primitive without_backs(bake::Primitive p);

}  // namespace citykiln::exporters
