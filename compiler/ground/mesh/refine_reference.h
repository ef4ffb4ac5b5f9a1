// Refines a cell's reference, the triangulation of the graded terrain at full detail, where the terrain bends without a
// grading line along the bend: at feet of banks at corners, at shores, in curves.
#pragma once

#include <span>
#include <vector>

#include "compiler/ground/cover/partition.h"
#include "compiler/ground/grading/graded_heights.h"

namespace citykiln::ground {

/// The refined triangulation.
struct RefinedReference {
  Delaunay triangulation;
  std::vector<Heights> heights;  ///< Per vertex the heights of the graded terrain, not rounded.
};

/// Samples the centres of faces, and the middles of edges that are no borders of land cover, each face on its own
/// height layer. Inserts points in faces with an error above kReferenceError_m, on roads above kQuantum_m.
///
/// @param partition     The cell as triangles, each with its land cover polygon.
/// @param face_heights  Height layer or water level of each polygon. Faces without a polygon lie on the land.
/// @param heights       Cache of sampled heights of the graded terrain.
///
/// Guarantees: borders, grading lines and the cell's border stay. No point is inserted within 0.5 m (on roads 0.25 m)
/// of a corner of the face it splits, so faces beside steps of the ground may keep a larger error. The order of faces
/// is the order of the partition. O(n log n) in vertices.
RefinedReference refine_reference(Partition&& partition, std::span<const FaceHeight> face_heights,
                                  const GradedHeights& heights);

}  // namespace citykiln::ground
