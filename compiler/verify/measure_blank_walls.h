// Measures blank walls: foundations that stand out of the ground by more than a storey, below a building with windows.
#pragma once

#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/scene/scene.h"
#include "compiler/verify/ground_index.h"

namespace citykiln::verify {

/// The blank wall of one building.
struct BlankWall {
  OsmId building;
  double area_m2 = 0;  ///< The area more than one storey above the ground beside it.
  Vec2 at;             ///< Where it is highest.
};

/// Returns the blank walls of a tile's buildings, by building. A wall is blank if it is vertical and begins at the
/// lower end of a building that stands on the ground, since walls with windows begin at the floor. Buildings without
/// windows, and walls against another building, do not count. O(triangles of buildings + metres of such walls).
/// @param ground  The ground of the same tile.
std::vector<BlankWall> measure_blank_walls(const scene::Chunk& chunk, const bake::BakedTile& tile,
                                           const GroundIndex& ground);

}  // namespace citykiln::verify
