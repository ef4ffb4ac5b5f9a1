// Measures the reference ground of cells against the graded terrain. The graded terrain is a function of the place: the
// terrain after roads and water have cut into it. The reference is its triangulation at full detail, against which
// errors of coarser meshes are certified.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "compiler/geometry/box.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/ground/mesh/reference.h"

namespace citykiln::verify {

/// The deviations of the reference at sampled places.
struct ReferenceErrors {
  std::uint64_t places = 0;
  std::uint64_t over = 0;  ///< Places that deviate by more than 2 · ground::kReferenceError_m.
  double largest_m = 0;    ///< Near a vertical face, up to its height.
  Vec2 at;                 ///< The place of the largest deviation.
};

/// Combines two measurements: adds counts and keeps the larger deviation.
ReferenceErrors combined(const ReferenceErrors& a, const ReferenceErrors& b);

/// Returns the reference of the cell that contains a place.
using ReferenceAt = std::function<const ground::Reference&(Vec2)>;

/// Samples one random place in each square of a grid over the box, on the height layer of the land cover there. Skips
/// standing water. O(samples).
/// @param a_side  Squares along each side of the box.
ReferenceErrors measure_reference_errors(const ground::GradedTerrain& graded,
                                         std::span<const ground::LandCoverPolygon> surfaces,
                                         const ReferenceAt& reference_at, const Box2& box, int a_side);

}  // namespace citykiln::verify
