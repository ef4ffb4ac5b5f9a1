// Refines a triangulation with points of the reference, at the worst face first, until all faces are within the
// tolerance.
#pragma once

#include <vector>

#include "compiler/ground/cover/partition.h"
#include "compiler/ground/mesh/reference.h"

namespace citykiln::ground {

/// A refined partition with the heights of its vertices.
struct Refined {
  Delaunay triangulation;
  std::vector<std::uint32_t> face_cover;
  std::vector<FaceHeight> face_height;
  std::vector<Heights> heights;  ///< Per vertex the reference's heights, rounded to 2^-10 m.
  double error_m =
      0;       ///< Largest vertical distance of a face from its layer of the reference; exact. 0 for standing water.
  Vec2 worst;  ///< The centre of the face with error_m.
  std::vector<std::uint32_t> off;  ///< The faces with an error above the tolerance.
};

/// Returns the reference's heights at a place, rounded to 2^-10 m.
Heights snapped_heights(const Reference& reference, const Place& place);

/// Refines a partition. Guarantees: no point is inserted on a constrained edge or the cell's border; error_m <=
/// tolerance_m, unless no further point could help. O(n log n) in points, times the reference's faces about each.
Refined refine(Partition&& partition, std::vector<FaceHeight>&& face_height, const Reference& reference,
               double tolerance_m);

}  // namespace citykiln::ground
