// Splits the primitives of a layer into those of single features.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "compiler/bake/baked_tile.h"

namespace citykiln::exporters {

struct SplitBuildings {
  std::map<std::uint32_t, std::vector<bake::Primitive>> buildings;  ///< By index into BakedTile::features.
  std::vector<bake::Primitive> rest;                                ///< Without features, or with mixed triangles.
};

/// Returns the triangles and vertices of each feature, in their order, in primitives of the same keys and order.
///
/// Guarantees: joining the buildings' primitives by key, in the order of features, gives the primitives back where
/// features ascend in them, as in baked tiles. Total. O(n log n).
SplitBuildings split_buildings(std::span<const bake::Primitive> primitives);

/// Appends a primitive of the same key.
void append_primitive(bake::Primitive& to, const bake::Primitive& from);

}  // namespace citykiln::exporters
