// Splits the primitives of a layer into primitives of single features.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "compiler/bake/baked_tile.h"

namespace citykiln::exporters {

/// The primitives of each building, and the rest.
struct SplitBuildings {
  std::map<std::uint32_t, std::vector<bake::Primitive>> buildings;  ///< By feature: the index into BakedTile::features.
  std::vector<bake::Primitive> rest;  ///< Primitives without features, or in which a triangle has several.
};

/// Returns the triangles and vertices of each feature. Primitives keep their keys; they and their triangles keep their
/// order.
///
/// Guarantees: if features ascend in each primitive, as in baked tiles, joining the buildings' primitives by key in the
/// order of features gives the input back. Accepts any primitives. O(n log n).
SplitBuildings split_buildings(std::span<const bake::Primitive> primitives);

/// Appends a primitive to one with the same key.
void append_primitive(bake::Primitive& to, const bake::Primitive& from);

}  // namespace citykiln::exporters
