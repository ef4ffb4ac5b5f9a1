// What the file of a region holds, counted for the model of its cost.
#pragma once

#include <cstdint>
#include <span>

#include "compiler/geometry/box.h"

namespace osmium {
class OSMObject;
}

namespace citykiln::regions {

/// One file of a cut. "Own" is what lies within the region itself, without its halo.
struct RegionFile {
  std::uint64_t bytes = 0;
  std::uint64_t nodes = 0, ways = 0, relations = 0;          ///< Nodes have tags.
  std::uint64_t way_nodes = 0, own_way_nodes = 0;            ///< Of all ways.
  std::uint64_t own_nodes = 0;                               ///< Nodes with tags: trees, lamps.
  std::uint64_t own_building_nodes = 0, own_road_nodes = 0;  ///< Those of own_way_nodes that are of such ways.
  /// Plants that areas ask for by plants/wood_defaults.inc and planting_defaults.inc: trees and shrubs of woods and
  /// parks; and vines, hedges and tufts of grass.
  std::uint64_t own_trees = 0, own_plantings = 0;
};

/// Counts the elements of a file, all but its bytes.
///
/// @param sorted   By type and id; nodes, ways and relations. Nodes of ways have places.
/// @param own_deg  The region's own part of the extent, in degrees of longitude and latitude.
/// @param own_m2   The area of that.
///
/// What lies within is decided in degrees, and areas are sampled along 64 parallels, so counts of plants are good to
/// some per cent; where areas overlap plants are counted twice. Linear in the nodes of the ways and of the areas' ways.
RegionFile contents_of(std::span<const osmium::OSMObject* const> sorted, const Box2& own_deg, double own_m2);

}  // namespace citykiln::regions
