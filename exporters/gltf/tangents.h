// Tangents: which way a texture runs over a surface, for readers of its normals.
#pragma once

#include <vector>

#include "compiler/bake/baked_tile.h"

namespace citykiln::exporters {

/// glTF's TANGENT, one a position, in the tile's own frame: the direction of growing u in the surface, at a right angle
/// to the normal, unit length; then 1 or -1, by which cross(normal, tangent) points up in the picture, against v.
/// @param primitive  With uvs.
/// Total: a corner of no triangle whose uvs tell a direction gets any. O(n).
std::vector<bake::Float4> tangents_of(const bake::Primitive& primitive);

}  // namespace citykiln::exporters
