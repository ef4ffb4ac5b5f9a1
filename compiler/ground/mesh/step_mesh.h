// From a triangulation whose vertices have a height a layer to a mesh: faces at their layers' heights, and upright
// faces where two layers part.
//
//      pavement ───┐ ← upright, of the upper face's surface; higher than a kerb, a wall of none
//                  └─── carriageway
#pragma once

#include "compiler/ground/expand.h"
#include "compiler/ground/grading/carved_normals.h"
#include "compiler/ground/mesh/refine.h"

namespace citykiln::ground {

/// @param surfaces  Heights of the surfaces.
/// @param rim       Where the neighbour is lower the step stands on the cell's border.
/// Vertices are shared within a layer, and between layers that touch; upright faces have their own, with level normals.
/// O(faces).
GroundMesh step_mesh(const Refined& refined, CarvedNormals& normals, std::span<const FaceHeight> surfaces,
                     std::span<const RimPiece> rim);

}  // namespace citykiln::ground
