// Finds the ground triangles of a baked tile at a place.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/geometry/box_grid.h"
#include "compiler/verify/ground/measure_ground.h"

namespace citykiln::verify {

/// The ground faces that are visible from above, in plane metres, with an index of their boxes.
struct GroundIndex {
  std::vector<GroundFace> faces;
  BoxGrid grid;
};

/// Indexes the ground of a tile. O(triangles).
GroundIndex index_ground(const bake::BakedTile& tile);

/// The ground at a place, on one face.
struct GroundHit {
  double z_m = 0;  ///< Plane metres.
  OsmId feature;   ///< The feature of the face.
};

/// Returns a hit for each ground face at a place, from the lowest to the highest. There is one hit inside a face and
/// none in a hole. On an edge that two faces share there are two, of equal heights; at a vertical face there are two,
/// of the faces above and below it; at corners there are more. A face within 2^-9 m of the place in plan counts, since
/// snapping moves borders by as much. O(1) expected.
///
/// @param p  The place, plane metres.
std::vector<GroundHit> ground_at(const GroundIndex& index, Vec2 p);

/// Returns the height of the highest ground within a distance in plan, plane metres; empty if there is none. Each face
/// counts with its height at its place nearest to p. Callers pass a level's error as the distance, to find the upper
/// side of a step in the ground that the level has moved sideways. O(faces near the distance).
///
/// @param p           Plane metres.
/// @param distance_m  The distance in plan.
std::optional<double> highest_ground_m(const GroundIndex& index, Vec2 p, double distance_m);

}  // namespace citykiln::verify
