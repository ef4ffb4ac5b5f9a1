// Builds the mesh of a cell from a triangulation whose vertices have one height per height layer: land, road,
// carriageway and water (height_layer.h): faces at the heights of their layers, and vertical faces where two layers
// differ.
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

/// The ground of a cell as a mesh.
struct GroundMesh {
  Mesh mesh;  ///< Upward faces, then vertical ones; positions on the 2^-10 m grid; normals of the graded terrain.
  std::vector<std::uint32_t> face_cover;  ///< Per triangle its land cover polygon (an index into the polygons from
                                          ///< which the ground was generated), or kNoLandCover.
  std::uint32_t first_vertical = 0;       ///< Triangles from here on are vertical: kerbs, quays, walls.
  /// Hausdorff distance in plan between simplified borders of land cover and the original ones.
  double border_error_m = 0;
  /// Largest vertical distance between mesh and graded terrain, layer by layer; exact (ground.md).
  double error_m = 0;
};

/// Builds the mesh.
/// @param refined      The triangulation.
/// @param normals      Cache of normals of the graded terrain.
/// @param surfaces     Height layer or water level of each polygon.
/// @param cell_border  Pieces of the cell's border where a ring runs along it. A vertical face is added where the
///                     neighbouring cell is lower.
/// Vertices are shared within a layer, and between layers of equal height. Vertical faces have their own vertices, with
/// horizontal normals. O(faces).
GroundMesh layered_mesh(const Refined& refined, GradedNormals& normals, std::span<const FaceHeight> surfaces,
                        std::span<const CellBorderPiece> cell_border);

}  // namespace citykiln::ground
