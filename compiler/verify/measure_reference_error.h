// Measures the deviation of the triangulated reference ground from the graded terrain that it approximates.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "compiler/geometry/box.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/ground/mesh/reference.h"

namespace citykiln::verify {

/// The deviations at the sampled places.
struct ReferenceErrors {
  std::uint64_t places = 0;
  std::uint64_t over = 0;  ///< Places that deviate by more than 2 · ground::kReferenceError_m.
  double largest_m = 0;    ///< Near a vertical face, up to its height.
  Vec2 at;
};

/// Combines two measurements: adds counts and keeps the larger deviation.
ReferenceErrors combined(const ReferenceErrors& a, const ReferenceErrors& b);

/// Returns the reference ground of the cell at a place.
using ReferenceAt = std::function<const ground::Reference&(Vec2)>;

/// Samples one random place in each square of a grid over the box, on the height layer of the land cover there. Skips
/// standing water. O(samples).
ReferenceErrors measure_reference_errors(const ground::GradedTerrain& graded,
                                         std::span<const ground::LandCoverPolygon> surfaces,
                                         const ReferenceAt& reference_at, const Box2& box, int a_side);

}  // namespace citykiln::verify
