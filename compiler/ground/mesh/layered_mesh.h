// Builds a mesh from a triangulation with one height per layer and vertex: faces at their layers' heights, and vertical
// faces where two layers differ.
//
//      pavement ───┐ ← a vertical face belongs to the upper face's polygon; if higher than a kerb, it is a wall and
//                  └─── carriageway                                                   belongs to no polygon
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/geometry/mesh.h"
#include "compiler/ground/grading/graded_normals.h"
#include "compiler/ground/mesh/refine.h"

namespace citykiln::ground {

struct GroundMesh {
  Mesh mesh;  ///< Upward faces, then vertical ones; positions on the 2^-10 m grid; normals of the graded terrain.
  std::vector<std::uint32_t> face_cover;  ///< Per triangle an index into the given polygons, or kNoLandCover.
  std::uint32_t first_vertical = 0;       ///< Triangles from here on are vertical: kerbs, quays, walls.
  double border_error_m = 0;  ///< Hausdorff distance in plan between borders and the borders that they replace.
  double error_m =
      0;  ///< Largest vertical distance between mesh and graded terrain, layer by layer; exact (ground.md).
};

/// Builds the mesh.
/// @param surfaces     Heights of the polygons.
/// @param cell_border  Pieces of the cell's border; if the neighbouring cell is lower there, a vertical face is added.
/// Vertices are shared within a layer, and between layers of equal height; vertical faces have their own, with
/// horizontal normals. O(faces).
GroundMesh layered_mesh(const Refined& refined, GradedNormals& normals, std::span<const FaceHeight> surfaces,
                        std::span<const CellBorderPiece> cell_border);

}  // namespace citykiln::ground
