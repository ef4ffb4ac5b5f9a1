// Outdoor stairs for highway=steps: blocks that stand on the graded ground, which is a ramp there. Coarse levels of
// detail omit the blocks and show the ramp.
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

/// The height of a step if none is tagged. It is changed a little so that the steps of a flight are equal and add up to
/// its rise.
inline constexpr double kRiser_m = 0.17;

/// The height of a handrail above the edges of the steps, and the least distance between its posts, except at corners
/// and ends.
inline constexpr double kHandrail_m = 0.9, kPostSpacing_m = 2;
/// The error of omitting handrails: their height above the edges of the steps, plus 0.3 m for the highest step.
inline constexpr double kHandrailError_m = kHandrail_m + 0.3;

/// The stairs of one way that lie in one tile.
struct Stairs {
  OsmId feature;
  Mesh mesh;     ///< Closed blocks, one for each straight piece of a tread. Plane metres, snapped.
  Mesh rails{};  ///< Handrails and their posts.
  /// The error of omitting mesh and rails: the largest height of a tread or handrail above the lowest ground across the
  /// way at that place, its edges included.
  double error_m = 0;
};

/// Returns the part of a stairway that lies inside a box. There are stairs only where the way is the topmost land
/// cover, and nothing where, for example, a road lies on it. Each part of the way that rises or falls by at least
/// 0.26 m is one flight, with steps of about Road::riser_m (kRiser_m if that is 0) and with the road's handrails;
/// flatter parts stay ramps. Treads are level across the way and nowhere below the ground under them. Treads that would
/// overlap in sharp bends are omitted. The meshes are empty if no part has stairs. O(length).
/// @param steps   The way, a road of class steps.
/// @param index   Land cover of the box and its surroundings.
/// @param ground  Graded terrain, valid in the box and within a road's width around it.
Stairs stairs_on(const roads::Road& steps, const ground::LandCoverIndex& index, const ground::GradedTerrain& ground,
                 const Box2& box);

}  // namespace citykiln::structures
