// Reads a building's tags: heights, roof, materials.
#pragma once

#include <string_view>

#include "compiler/map/tags/read_context.h"

namespace citykiln::map {

/// The value of building=* or building:part=* that gives a building's class; empty: the tags describe no building.
struct BuildingValue {
  std::string_view text;
  bool is_part = false;
};

/// Returns the value of building=*, else of building:part=*. Shelters, canopies and roofs over platforms without either
/// (amenity=shelter, man_made=canopy, covered=yes) are buildings, too.
BuildingValue building_value(const ReadContext& context, source::Range tags);

/// True for what carries a bridge (bridge:support=*): a pier is no house.
bool is_bridge_support(const ReadContext& context, source::Range tags);

/// Returns a footprint without its polygon: the values that all polygons of an element share.
///
/// @param value    The value of building=* or building:part=*, which gives the class.
/// @param area_m2  The area of the polygons.
///
/// The height follows from height=*, else building:levels=*, else the class, else the area; the roof from roof:*.
/// Walls are left out for roofs, shelters, and wall=no (is_open).
/// Diagnosed: kBadTagValue for unreadable values.
Footprint read_building_tags(const ReadContext& context, OsmId id, source::Range tags, std::string_view value,
                             double area_m2);

/// True for places where something is sold or served: shop=*, amenity=restaurant and similar.
bool is_shop(const ReadContext& context, source::Range tags);

}  // namespace citykiln::map
