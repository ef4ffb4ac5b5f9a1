// Refines a triangulation with points of the reference, at the worst face first, until no face is off by more than the
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
  std::vector<Heights> heights;  ///< One per vertex: the reference's, rounded to 2^-10 m.
  double error_m =
      0;  ///< Largest vertical distance of a face to its layer of the reference; exact. Standing water is level: 0.
  Vec2 worst;                      ///< The centre of the face that is off by error_m.
  std::vector<std::uint32_t> off;  ///< The faces that are off by more than the tolerance.
};

/// Returns the reference's heights at a place, rounded to 2^-10 m.
Heights snapped_heights(const Reference& reference, const Place& place);

/// Refines. Guarantees: no point on a constrained edge or the cell's border; error_m <= tolerance_m, or no further
/// point could help. O(n log n) in points, times the reference's faces about each.
Refined refine(Partition&& partition, std::vector<FaceHeight>&& face_height, const Reference& reference,
               double tolerance_m);

}  // namespace citykiln::ground
