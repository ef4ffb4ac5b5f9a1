// Tangents: the direction of a texture's u on a surface, for normal maps.
#pragma once

#include <vector>

#include "compiler/bake/baked_tile.h"

namespace citykiln::exporters {

/// Returns glTF's TANGENT for each position, in the tile's frame: the direction of growing u in the surface, orthogonal
/// to the normal, unit length; then 1 or -1, so that cross(normal, tangent) times it points up in the image, against v.
/// @param primitive  With uvs.
/// Total: vertices of triangles with degenerate uvs get any orthogonal direction. O(n).
std::vector<bake::Float4> tangents_of(const bake::Primitive& primitive);

}  // namespace citykiln::exporters
