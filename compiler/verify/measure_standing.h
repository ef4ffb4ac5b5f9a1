// Measures whether buildings stand on the ground: their floor is not above it on all sides, and their top not below it.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/scene/scene.h"
#include "compiler/verify/ground_index.h"

namespace citykiln::verify {

/// The height of a floor above the highest ground at the walls that does not count: a storey of the building, at least
/// this. Parts of one building have a common floor, which is less than a storey above the lowest ground of each.
inline constexpr double kFloorAbove_m = 3;

/// A building above or below the ground.
struct OffGround {
  OsmId building;
  double off_m = 0;  ///< > 0: its floor above the highest ground at its walls; < 0: its top below the lowest.
  Vec2 at;           ///< A corner.
};

/// The buildings of a tile that stand on the ground by their recipes.
struct Standing {
  std::uint64_t buildings = 0;
  std::vector<OffGround> off;  ///< Buildings farther off than allowed.
};

/// Measures the buildings whose walls have ground of the tile everywhere, at their corners and in the middle between
/// them. Roofs down to the ground and treads, which have no storeys, have no floor. O(corners).
/// @param error_m  The error of the ground.
Standing measure_standing(const scene::Chunk& chunk, const GroundIndex& ground, double error_m);

}  // namespace citykiln::verify
