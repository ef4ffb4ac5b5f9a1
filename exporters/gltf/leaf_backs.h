// Back sides of leaves: cards on cutouts are seen from both sides, with one normal for both.
//
// A material that is doubleSided turns the normal of a face that is seen from behind. Normals of leaves point out of
// the crown, so that turned ones would point into it and the leaf would be black. A second face, turned over, with the
// same normals is right in all programs.
#pragma once

#include <cstdint>

#include "compiler/bake/baked_tile.h"

namespace citykiln::exporters {

/// Primitives with more cards, seen from nearby, keep single faces that are doubleSided, since twice as many would be
/// slow.
inline constexpr std::size_t kMostTrianglesWithBacks = 2000;
/// Opacity in COLOR_0 that marks the vertices of back sides.
inline constexpr std::uint8_t kBackOpacity = 254;

/// Whether a primitive is written with back sides: cards on a cutout, not too many.
bool has_backs(const bake::Primitive& p);

/// Appends back sides: a copy of each vertex, and each triangle turned over.
bake::Primitive with_backs(bake::Primitive p);

/// Removes back sides, whatever the order of vertices and triangles. without_backs(with_backs(p)) == p.
bake::Primitive without_backs(const bake::Primitive& p);

}  // namespace citykiln::exporters
