// Borders and carve lines foretell most bends of the graded terrain, but not all: feet of banks at corners, shores,
// what is curved. A triangulation takes points there, until it follows the ground wherever it is looked at.
#pragma once

#include <span>
#include <vector>

#include "compiler/ground/cover/partition.h"
#include "compiler/ground/grading/graded_heights.h"

namespace citykiln::ground {

struct RefinedReference {
  Delaunay triangulation;
  std::vector<Heights> heights;  ///< One a vertex: of the graded terrain, not rounded.
};

/// Looks at the centres of faces and at the middles of edges that are no borders, each face on its own layer, and puts
/// points in where a face strays by more than kReferenceError_m, on roads by more than kQuantum_m.
/// @param face_heights  Of each surface of the partition; kNoLandCover lies on the land.
/// Guarantees: nothing on borders, lines or the cell's border changes; no point goes in within half a metre, on roads a
/// quarter, of a corner of the face it splits, so beside steps of the ground a face may stay off. Depends on the order
/// of faces, which the partition alone decides. O(n log n) in vertices, each asked for once.
/// @param heights  Those that are known already need not be made.
RefinedReference refine_reference(Partition&& partition, std::span<const FaceHeight> face_heights,
                                  const GradedHeights& heights);

}  // namespace citykiln::ground
