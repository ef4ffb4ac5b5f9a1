// Looks up ground triangles of a baked tile by place.
#pragma once

#include <span>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/geometry/box_grid.h"
#include "compiler/verify/measure_ground.h"

namespace citykiln::verify {

/// The ground faces that are visible from above.
struct GroundIndex {
  std::vector<GroundFace> faces;
  BoxGrid grid;
};

/// Indexes the ground of a tile. O(triangles).
GroundIndex index_ground(const bake::BakedTile& tile);

struct GroundHit {
  double z_m = 0;  ///< Plane metres.
  OsmId feature;   ///< Of the face.
};

/// The faces at a place, from the lowest to the highest: two at a step, none in a hole. A face within 2^-9 m of the
/// place counts, since snapping moves borders. O(1) expected.
std::vector<GroundHit> ground_at(const GroundIndex& index, Vec2 p);

}  // namespace citykiln::verify
