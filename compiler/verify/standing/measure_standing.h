// Measures whether buildings stand on the ground. A floor far above the ground on all sides, or a top below the ground,
// is an error.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/scene/scene.h"
#include "compiler/verify/ground/ground_index.h"

namespace citykiln::verify {

/// The height that a floor may have above the highest ground at the walls, or a storey of the building if that is more.
/// Parts of one building have a common floor, which is less than a storey above the lowest ground of each.
inline constexpr double kMostFloorRise_m = 3;

/// A building above or below the ground.
struct OffGround {
  OsmId building;
  /// > 0: height of its floor above the highest ground at its walls; < 0: height of its top below the lowest ground
  /// there.
  double off_m = 0;
  Vec2 at;  ///< Its first corner.
};

/// The measured buildings of a tile.
struct FloorMeasure {
  std::uint64_t buildings = 0;  ///< How many were measured.
  std::vector<OffGround> off;   ///< Buildings farther off the ground than allowed.
};

/// Measures the buildings that stand on the ground by their recipes. The ground is taken at the corners and the middles
/// of the edges of the outer ring; a building is left out if the tile has no ground at one of these places. The floor
/// of buildings without storeys, such as roofs down to the ground and treads, is not measured. O(corners).
/// @param error_m  The error of the ground, which is allowed in addition.
FloorMeasure measure_standing(const scene::Chunk& chunk, const GroundIndex& ground, double error_m);

}  // namespace citykiln::verify
