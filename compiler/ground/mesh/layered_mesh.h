// From a triangulation whose vertices have a height a layer to a mesh: faces at their layers' heights, and vertical
// faces where two layers part.
//
//      pavement ───┐ ← vertical, of the upper face's surface; higher than a kerb, a wall of none
//                  └─── carriageway
#pragma once

#include "compiler/ground/generate.h"
#include "compiler/ground/grading/graded_normals.h"
#include "compiler/ground/mesh/refine.h"

namespace citykiln::ground {

/// @param surfaces  Heights of the surfaces.
/// @param rim       Where the neighbour is lower the step stands on the cell's border.
/// Vertices are shared within a layer, and between layers that touch; vertical faces have their own, with level
/// normals. O(faces).
GroundMesh layered_mesh(const Refined& refined, GradedNormals& normals, std::span<const FaceHeight> surfaces,
                        std::span<const CellBorderPiece> cell_border);

}  // namespace citykiln::ground
