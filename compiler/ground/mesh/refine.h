// Refines the triangulation of a cell with points of its reference (the graded terrain at full detail) until all faces
// are within the tolerance, the face with the largest error first.
#pragma once

#include <vector>

#include "compiler/ground/cover/partition.h"
#include "compiler/ground/mesh/reference.h"

namespace citykiln::ground {

/// A refined partition with the heights of its vertices.
struct Refined {
  Delaunay triangulation;
  std::vector<std::uint32_t> face_cover;  ///< Per face its land cover polygon, or kNoLandCover.
  std::vector<FaceHeight> face_height;    ///< Per face its height layer, or its level for standing water.
  std::vector<Heights> heights;           ///< Per vertex the reference's heights, rounded to 2^-10 m.
  /// Largest vertical distance of a face from its layer of the reference; exact. 0 for standing water.
  double error_m = 0;
  Vec2 worst;                      ///< The centre of the face with error_m.
  std::vector<std::uint32_t> off;  ///< Indices of faces with an error above the tolerance.
};

/// Returns the reference's heights at a place, one per height layer (height_layer.h), rounded to 2^-10 m.
Heights snapped_heights(const Reference& reference, const Place& place);

/// Refines a partition of a cell.
/// @param face_height  One per face of the partition.
/// Guarantees: no point is inserted on a constrained edge or on the cell's border; error_m <= tolerance_m, unless no
/// further point could help. O(n log n) in points, times the reference's faces about each.
Refined refine(Partition&& partition, std::vector<FaceHeight>&& face_height, const Reference& reference,
               double tolerance_m);

}  // namespace citykiln::ground
