// Reads a building's tags: heights, roof, materials.
#pragma once

#include <string_view>

#include "compiler/map/read_context.h"

namespace citykiln::map {

/// Returns a footprint without its polygon: the values that all polygons of an element share.
///
/// @param value    The value of building=* or building:part=*, which gives the class.
/// @param area_m2  The area of the polygons.
///
/// The height follows from height=*, else building:levels=*, else the class, else the area; the roof from roof:*.
/// Diagnosed: kBadTagValue for unreadable values, kNoBuildingHeight if neither height nor levels are tagged.
Footprint read_building_tags(const ReadContext& context, OsmId id, source::Range tags, std::string_view value,
                             double area_m2);

/// True for places where something is sold or served: shop=*, amenity=restaurant and similar.
bool is_shop(const ReadContext& context, source::Range tags);

}  // namespace citykiln::map
