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
/// Method: a triangle is split along the straight line through each clip edge whose bounding box touches the triangle's
/// in plan. Each piece is then kept or removed as a whole. Bodies stay open where they are cut.
///
/// Guarantees: a mesh inside the clip stays unchanged, to the byte, if no clip edge's bounding box in plan comes within
/// 1 m of the mesh's. Nearer meshes may get new vertices inside the clip, too. New vertices are within 2^-10 m of the
/// line of a clip edge in plan, on the 2^-10 m grid, with linearly interpolated normals (unit length), texture
/// coordinates and tints. Two triangles that share a mesh edge, and are split by the same clip edges, get the same
/// vertices on the mesh edge. O(triangles · edges near).
void clip_to_outline(std::span<materials::MaterialMesh* const> meshes, const scene::Clip& clip);

}  // namespace citykiln::bake
