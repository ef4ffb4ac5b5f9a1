// Meshes without normals: readers give each face its own, as glTF asks, and a third of their import is saved.
#pragma once

#include "compiler/bake/baked_tile.h"

namespace citykiln::exporters {

/// Whether normals say no more than the faces do: those of each triangle's corners are within 1° of its own. Triangles
/// less than 1 mm high have no say. O(n).
bool is_flat(const bake::Primitive& primitive);

/// Returns a primitive without normals. Connected triangles share vertices that differed in their normals alone.
bake::Primitive without_normals(bake::Primitive&& primitive);

/// Gives each triangle its own normal: the inverse, but for the order of vertices. Vertices are shared by triangles
/// with equal normals. Up where a triangle has no area. O(n).
/// @param primitive  Without normals.
bake::Primitive with_face_normals(const bake::Primitive& primitive);

}  // namespace citykiln::exporters
