// Clips meshes to the clip of a scene: the polygons beyond which there is no ground.
#pragma once

#include <span>

#include "compiler/materials/material_mesh.h"
#include "compiler/scene/clip.h"

namespace citykiln::bake {

/// Removes the parts of meshes beyond a clip. Does nothing if the clip is empty.
///
/// @param meshes  The meshes of one object; no null pointers.
///
/// Guarantees: meshes inside stay unchanged, to the byte; new vertices are within 2^-10 m of the clip's edges in plan,
/// on the 2^-10 m grid, with linearly interpolated normals, texture coordinates and tints; two triangles of a mesh that
/// share an edge get the same vertices. Bodies stay open where they are cut. Method: triangles that an edge of the clip
/// comes near are split along its line; each piece is inside or outside as a whole. O(triangles · edges near).
void clip_to_outline(std::span<materials::MaterialMesh* const> meshes, const scene::Clip& clip);

}  // namespace citykiln::bake
