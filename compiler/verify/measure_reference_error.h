// Deviation of the triangulated reference ground from the graded terrain that it approximates.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "compiler/geometry/box.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/ground/mesh/reference.h"

namespace citykiln::verify {

struct ReferenceErrors {
  std::uint64_t places = 0;
  std::uint64_t over = 0;  ///< Places off by more than 2 · ground::kReferenceError_m.
  double largest_m = 0;    ///< At a step in the ground up to the height of the step.
  Vec2 at;
};

/// The counts added, and the larger of the deviations.
ReferenceErrors combined(const ReferenceErrors& a, const ReferenceErrors& b);

/// The reference ground of the cell at a place.
using ReferenceAt = std::function<const ground::Reference&(Vec2)>;

/// Samples one random place in every square of a lattice over the box, on the layer of the land cover there. Skips
/// standing water. O(samples).
/// @param a_side  Squares along each side of the box, > 0.
ReferenceErrors measure_reference_errors(const ground::GradedTerrain& graded,
                                         std::span<const ground::LandCoverPolygon> surfaces,
                                         const ReferenceAt& reference_at, const Box2& box, int a_side);

}  // namespace citykiln::verify
