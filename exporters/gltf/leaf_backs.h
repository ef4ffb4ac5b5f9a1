// Back sides of leaves: cards on cutouts are seen from both sides, and have one normal for both.
//
// A doubleSided material flips the normal of a face that is seen from behind. Normals of leaves point out of the crown,
// so flipped ones would point into it, and the leaf would be black. A second face with reversed winding and the same
// normals is right in all programs.
#pragma once

#include <cstddef>

#include "compiler/bake/baked_tile.h"

namespace citykiln::exporters {

/// The number of triangles above which a primitive has no back sides and is doubleSided instead: it is for near views,
/// and twice as many triangles would be slow.
inline constexpr std::size_t kMostTrianglesWithBacks = 2000;

/// True if a primitive is written with back sides: cards on a cutout, at most kMostTrianglesWithBacks.
bool has_backs(const bake::Primitive& p);

/// Appends back sides: a copy of each vertex, and each triangle with reversed winding. An opacity of 254 in COLOR_0
/// marks vertices of back sides.
bake::Primitive with_backs(bake::Primitive p);

/// Removes back sides, in any order of vertices and triangles. without_backs(with_backs(p)) == p.
bake::Primitive without_backs(const bake::Primitive& p);

}  // namespace citykiln::exporters
