// Refines the reference where grading lines did not foresee how the graded terrain bends: feet of banks at corners,
// shores, curves.
#pragma once

#include <span>
#include <vector>

#include "compiler/ground/cover/partition.h"
#include "compiler/ground/grading/graded_heights.h"

namespace citykiln::ground {

struct RefinedReference {
  Delaunay triangulation;
  std::vector<Heights> heights;  ///< One per vertex: of the graded terrain, not rounded.
};

/// Samples the centres of faces and the middles of edges that are no borders, each face on its own layer, and inserts
/// points where a face is off by more than kReferenceError_m, on roads by more than kQuantum_m.
/// @param face_heights  One per polygon of the partition; kNoLandCover lies on the land.
/// @param heights       Heights sampled before are reused.
/// Guarantees: borders, lines and the cell's border stay; no point is inserted within 0.5 m (on roads 0.25 m) of a
/// corner of the face it splits, so beside steps of the ground a face may stay off. The order of faces is that of the
/// partition. O(n log n) in vertices.
RefinedReference refine_reference(Partition&& partition, std::span<const FaceHeight> face_heights,
                                  const GradedHeights& heights);

}  // namespace citykiln::ground
