// Clips meshes at the sides of the extent, and closes solid bodies there.
//
//        extent |            the part beyond the side is removed;
//     __________|. . . .     the cut face of a solid body lies in the side
//    |__________|. . . .
//               |
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/materials/material_mesh.h"

namespace citykiln::bake {

/// Removes the parts of meshes outside the extent.
///
/// @param meshes  The meshes of one object; no null pointers.
/// @param extent  A box with corners on the 2^-10 m grid.
///
/// Guarantees: meshes inside the extent stay unchanged, to the byte; new vertices lie exactly on a side, are on the
/// 2^-10 m grid and have linearly interpolated normals, texture coordinates and tints; two triangles that share an edge
/// get the same vertices, also triangles of different meshes. A mesh outside becomes empty. Method: Sutherland, Hodgman
/// (1974), one side after the other. O(vertices + triangles · log).
void clip_to_extent(std::span<materials::MaterialMesh* const> meshes, const Box2& extent);

/// Clips a solid body, whose meshes together are closed, like clip_to_extent(). Returns the faces in the extent's sides
/// that close the remaining body. Where the body was open, a straight line from end to begin of the open border closes
/// the face.
Mesh clip_solid_to_extent(std::span<materials::MaterialMesh* const> meshes, const Box2& extent);

}  // namespace citykiln::bake
