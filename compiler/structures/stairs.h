// Outdoor stairs for highway=steps. The graded ground below them is a ramp, so coarse levels can omit the stairs.
//
//               ___|      treads are level, each at the height of the ground at its upper end
//           ___|  .
//       ___|  .           ramp
//      |  .
#pragma once

#include <vector>

#include "compiler/geometry/mesh.h"
#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/roads/recipe.h"

namespace citykiln::structures {

/// Approximate height of a step; all steps of a flight are equal.
inline constexpr double kRiser_m = 0.17;

/// The height of a handrail above the edges of the steps, and the distance of its posts.
inline constexpr double kHandrail_m = 0.9, kPostSpacing_m = 2;
/// The error of omitting handrails: their height above the edges of the steps, and the highest step.
inline constexpr double kHandrailError_m = kHandrail_m + 0.3;

/// The stairs of one way that lie in one tile.
struct Stairs {
  OsmId feature;
  Mesh mesh;           ///< Closed blocks, one for each straight piece of a tread. Plane metres, snapped.
  Mesh rails{};        ///< Handrails and their posts.
  double error_m = 0;  ///< Largest height of a tread or handrail above the lowest ground under it, or at the edges of
                       ///< the way: the error of omitting both.
};

/// Returns the stairs of a way with steps inside a box, at the places where that way is the topmost land cover. Each
/// part that rises or falls is one flight, with steps of Road::riser_m or kRiser_m and with the road's handrails.
/// Treads are level across the way and nowhere below the ground under them. Treads that would overlap in sharp bends
/// are omitted. O(length).
/// @param steps   The way, a road of class steps.
/// @param index   Land cover of the box and its surroundings.
/// @param ground  Graded terrain, valid in the box and within a road's width around it.
Stairs stairs_on(const roads::Road& steps, const ground::LandCoverIndex& index, const ground::GradedTerrain& ground,
                 const Box2& box);

}  // namespace citykiln::structures
