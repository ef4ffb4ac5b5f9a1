// Writes an invented map as an OpenStreetMap extract.
#pragma once

#include <cstddef>
#include <string>

#include "compiler/contract/result.h"
#include "compiler/invent/invented_map.h"
#include "compiler/invent/write/world_place.h"

namespace citykiln::invent {

/// The numbers of elements in a written map.
struct MapCounts {
  std::size_t nodes = 0, ways = 0, relations = 0;
};

/// Writes the map as .osm.pbf, by libosmium. Points of equal places, in whole 1e-7 degrees, are one node; an area with
/// holes is a multipolygon; ids count from 1 in the order of points, lines and areas; the header has the box of the
/// mapped square. Lines and rings that become too short are left out.
///
/// Guarantees: elements are sorted; the file is a function of map, place and side. Errors: the file cannot be written.
Result<MapCounts> write_map(const InventedMap& map, const WorldPlace& place, double side_m, const std::string& path);

}  // namespace citykiln::invent
