// The ground of a baked tile, asked place by place.
#pragma once

#include <span>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/geometry/box_grid.h"
#include "compiler/verify/measure_ground.h"

namespace citykiln::verify {

/// Its faces that look upwards.
struct GroundIndex {
  std::vector<GroundFace> faces;
  BoxGrid grid;
};

/// @param standing  Overlooked. O(triangles).
GroundIndex index_ground(const bake::BakedTile& tile, const NonGroundObjects& non_ground);

struct GroundHit {
  double z_m = 0;  ///< Plane metres.
  OsmId feature;   ///< What covers it.
};

/// The faces that hold the place, or end beside it by no more than the plane's grid moves borders, from the lowest to
/// the highest: two where the ground steps, none where there is none. O(1) expected.
std::vector<GroundHit> ground_at(const GroundIndex& index, Vec2 p);

}  // namespace citykiln::verify
