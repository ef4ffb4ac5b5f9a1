// Measures blank walls: walls without windows between the ground and the lowest floor of a building with windows, where
// they are higher than a storey.
#pragma once

#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/scene/scene.h"
#include "compiler/verify/ground/ground_index.h"

namespace citykiln::verify {

/// The blank wall of one building.
struct BlankWall {
  OsmId building;
  double area_m2 = 0;  ///< Area of its parts that are more than one storey above the ground beside them.
  Vec2 at;             ///< Where it is highest.
};

/// Returns the blank walls of a tile's buildings of at least 1 m², one for each building, by building. A wall is blank
/// if it is vertical and begins at the lower end of a building that stands on the ground; walls with windows begin at
/// the floor. Buildings without windows, walls against another building, and openings for ways do not count.
/// O(triangles of buildings + metres of such walls).
/// @param ground  The ground of the same tile.
std::vector<BlankWall> measure_blank_walls(const scene::Chunk& chunk, const bake::BakedTile& tile,
                                           const GroundIndex& ground);

}  // namespace citykiln::verify
