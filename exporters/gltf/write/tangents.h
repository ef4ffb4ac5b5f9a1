// Computes tangents, the direction of a texture's u on a surface, for normal maps.
#pragma once

#include <vector>

#include "compiler/bake/baked_tile.h"

namespace citykiln::exporters {

/// Returns glTF's TANGENT for each position, in the tile's axes (z up), not glTF's. The first three components are the
/// direction of increasing u in the surface, orthogonal to the normal, of unit length. The fourth, 1 or -1, times
/// cross(normal, tangent) points up in the image, against v.
///
/// @param primitive  With uvs and normals. Vertices of triangles with degenerate uvs get an arbitrary orthogonal
///                   direction. O(n).
std::vector<bake::Float4> tangents_of(const bake::Primitive& primitive);

}  // namespace citykiln::exporters
