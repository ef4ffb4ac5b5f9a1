// Counts the elements in the file of a region, from which the cost of compiling it is estimated (expected_cost.h).
#pragma once

#include <cstdint>
#include <span>

#include "compiler/geometry/box.h"

namespace osmium {
class OSMObject;
}

namespace citykiln::regions {

/// The contents of one file: a region and its halo, the data around it that it is compiled with. Members that begin
/// with own_ count only the region itself; the others count the whole file.
struct RegionFile {
  std::uint64_t bytes = 0;
  std::uint64_t nodes = 0, ways = 0, relations = 0;  ///< Only nodes with tags count.
  std::uint64_t way_nodes = 0, own_way_nodes = 0;    ///< Nodes of all ways.
  std::uint64_t own_nodes = 0;                       ///< Nodes with tags, such as trees and lamps.
  std::uint64_t own_building_nodes = 0,
                own_road_nodes = 0;  ///< Nodes of buildings and of roads, included in own_way_nodes.
  /// Plants on areas: trees and shrubs of woods and parks (plants/wood_defaults.inc); vines, hedges and tufts of grass
  /// (plants/planting_defaults.inc).
  std::uint64_t own_trees = 0, own_plantings = 0;
};

/// Counts the elements of a file. `bytes` stays 0. Cannot fail.
///
/// @param sorted   Nodes, ways and relations, by type and id. Ways hold the locations of their nodes.
/// @param own_deg  The region's own part of the extent, in degrees: x is the longitude, y the latitude. It decides
///                 which elements are "own".
/// @param own_m2   The area of that part.
///
/// Areas are sampled along 64 parallels, so counts of plants are accurate to some per cent. Where areas overlap, plants
/// are counted twice. Linear in the nodes of the ways and of the areas' ways.
RegionFile contents_of(std::span<const osmium::OSMObject* const> sorted, const Box2& own_deg, double own_m2);

}  // namespace citykiln::regions
