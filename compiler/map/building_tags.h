// What tags say of a building: its heights, its roof, what it is made of.
#pragma once

#include <string_view>

#include "compiler/map/read_context.h"

namespace citykiln::map {

/// A footprint without its place: what is said once for all polygons of an element.
///
/// Heights by height, else building:levels, else the class of `value` (of building=* or building:part=*), else the
/// area; roofs by roof:*; what cannot be read is diagnosed kBadTagValue, heights that nobody tells kNoBuildingHeight.
Footprint described(const ReadContext& context, OsmId id, source::Range tags, std::string_view value, double area_m2);

/// True where tags say that something is sold or served: shop=*, amenity=restaurant and the like.
bool is_shop(const ReadContext& context, source::Range tags);

}  // namespace citykiln::map
