// Obstacles: the segments that hide a street from a place.
#pragma once

#include <utility>
#include <vector>

#include "compiler/geometry/box_grid.h"
#include "compiler/parcels/parcels.h"

namespace citykiln::parcels {

/// Segments that cannot be looked across, with an index of their boxes.
struct Obstacles {
  std::vector<std::pair<Vec2, Vec2>> segments;
  BoxGrid grid;
};

/// Returns the axes of streets and barriers and the edges of taken land.
Obstacles obstacles_of(const std::vector<Line>& lines, const std::vector<Polygon>& taken);

/// True if no obstacle crosses the segment from a to b.
bool is_seen(const Obstacles& obstacles, Vec2 a, Vec2 b);

/// Returns the distance from p at which an obstacle lies in the direction `towards`; at most `most_m`.
/// @param towards  Length 1.
double distance_to_obstacle(const Obstacles& obstacles, Vec2 p, Vec2 towards, double most_m);

}  // namespace citykiln::parcels
