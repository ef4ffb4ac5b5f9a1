// Reads a building's tags: heights, roof, materials.
#pragma once

#include <string_view>

#include "compiler/map/read_context.h"

namespace citykiln::map {

/// Returns a footprint without its polygon: all that is common to the polygons of an element.
///
/// Heights come from height, else building:levels, else the class of `value` (of building=* or building:part=*), else
/// the area; roofs from roof:*. Diagnosed: kBadTagValue for unreadable values, kNoBuildingHeight where neither height
/// nor levels are tagged.
Footprint read_building_tags(const ReadContext& context, OsmId id, source::Range tags, std::string_view value,
                             double area_m2);

/// True where something is sold or served: shop=*, amenity=restaurant and similar.
bool is_shop(const ReadContext& context, source::Range tags);

}  // namespace citykiln::map
