// Refines the reference at bends of the graded terrain without grading lines: feet of banks at corners, shores, curves.
#pragma once

#include <span>
#include <vector>

#include "compiler/ground/cover/partition.h"
#include "compiler/ground/grading/graded_heights.h"

namespace citykiln::ground {

struct RefinedReference {
  Delaunay triangulation;
  std::vector<Heights> heights;  ///< Per vertex the heights of the graded terrain, not rounded.
};

/// Samples the centres of faces and the middles of edges that are no borders, each face on its own layer. Inserts
/// points in faces with an error above kReferenceError_m, on roads above kQuantum_m.
/// @param face_heights  One per polygon of the partition; kNoLandCover lies on the land.
/// @param heights       Cache of heights that were sampled before.
/// Guarantees: borders, lines and the cell's border stay. No point is inserted within 0.5 m (on roads 0.25 m) of a
/// corner of the face it splits, so faces beside steps of the ground may keep a larger error. The order of faces is
/// that of the partition. O(n log n) in vertices.
RefinedReference refine_reference(Partition&& partition, std::span<const FaceHeight> face_heights,
                                  const GradedHeights& heights);

}  // namespace citykiln::ground
