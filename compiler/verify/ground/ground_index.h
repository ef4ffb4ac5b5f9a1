// Finds the ground triangles of a baked tile at a place.
#pragma once

#include <span>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/geometry/box_grid.h"
#include "compiler/verify/ground/measure_ground.h"

namespace citykiln::verify {

/// The ground faces that are visible from above, with an index of their boxes.
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

/// Returns the ground faces at a place, from the lowest to the highest: two at a vertical face, none in a hole. A face
/// within 2^-9 m of the place counts, since snapping moves borders. O(1) expected.
std::vector<GroundHit> ground_at(const GroundIndex& index, Vec2 p);

}  // namespace citykiln::verify
