// Meshes without normals: glTF readers shade their faces flat. This saves Blender a third of its import time.
#pragma once

#include "compiler/bake/baked_tile.h"

namespace citykiln::exporters {

/// True if the normals at the corners of each triangle are within 1° of the triangle's normal. Ignores triangles less
/// than 1 mm high. O(n).
bool is_flat(const bake::Primitive& primitive);

/// The parts of a primitive that need no normals, and those that do. Either may be without triangles.
struct ByShading {
  bake::Primitive flat, smooth;
};

/// Divides a primitive into its runs (object_runs.h) that are flat (is_flat()) and the others, each in order. O(n).
ByShading by_shading(const bake::Primitive& primitive);

/// Returns a primitive without normals. Connected triangles share vertices that differed only in their normals.
bake::Primitive without_normals(bake::Primitive&& primitive);

/// Gives each triangle its own normal, or up if it has no area. Inverse of without_normals() but for the order of
/// vertices. Triangles with equal normals share vertices. O(n).
/// @param primitive  Without normals.
bake::Primitive with_face_normals(const bake::Primitive& primitive);

}  // namespace citykiln::exporters
