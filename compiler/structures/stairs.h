// Outdoor stairs: what `highway=steps` is where it is seen close by. They lie on the graded terrain, which is a ramp
// under them, so that from afar they may be left out.
//
//               ___|      treads are level; each lies as high as the ground at its upper end
//           ___|  .
//       ___|  .           the ramp
//      |  .
#pragma once

#include <vector>

#include "compiler/geometry/mesh.h"
#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/roads/recipe.h"

namespace citykiln::structures {

/// Steps are about as high as this, all of one flight alike. They are level across the way: none lies below its ground.
inline constexpr double kRiser_m = 0.17;

/// What of a way's steps lies in a tile.
struct Stairs {
  OsmId feature;
  Mesh mesh;           ///< A closed block a tread, down into the ground. Plane metres, snapped.
  double error_m = 0;  ///< How far they stand out of the ground: what leaving them out moves.
};

/// The stairs of a road of steps, as far as its own surface is on top, in the box. Where it rises and falls it has a
/// flight for each; where it does neither, none. Where it turns so sharply that lines across it cross, a tread is left
/// out. O(length).
/// @param map      Of the surfaces that cover the box, and what is near it.
/// @param ground   Known in the box and a road's breadth around it.
Stairs stairs_on(const roads::Road& steps, const ground::LandCoverIndex& map, const ground::GradedTerrain& ground,
                 const Box2& box);

}  // namespace citykiln::structures
