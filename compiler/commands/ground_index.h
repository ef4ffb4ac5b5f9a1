// The ground of a baked tile, asked place by place.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "compiler/bake/baked.h"
#include "compiler/commands/measure_ground.h"
#include "compiler/geometry/box_grid.h"

namespace citykiln::commands {

/// Its faces that look upwards.
struct GroundIndex {
  std::vector<GroundFace> faces;
  BoxGrid grid;
};

/// @param leaving  Sorted: features that leave the ground; overlooked. O(triangles).
GroundIndex index_ground(const bake::BakedTile& tile, std::span<const OsmId> leaving);

struct GroundPlace {
  double z_m = 0;  ///< Plane metres.
  OsmId feature;   ///< What covers it.
};

/// The lowest face that holds the place, its edges too; none where there is no ground. O(1) expected.
std::optional<GroundPlace> lowest_ground_at(const GroundIndex& index, Vec2 p);

}  // namespace citykiln::commands
