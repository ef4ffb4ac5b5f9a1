// Converts boxes of the plane to longitude and latitude.
#pragma once

#include <string>

#include "compiler/geometry/box.h"
#include "compiler/map/plane/plane.h"
#include "compiler/source/osm_data.h"

namespace citykiln::map {

/// Returns the smallest box in degrees that contains the corners, the middles of the sides and the centre of a box of
/// the plane, whose sides are curves in degrees.
source::LonLatBox lonlat_box_of(const Box2& box, const Plane& plane);

/// Returns the same box as GeoJSON writes it (RFC 7946, 5.2): west is more than east if it is across 180°.
source::LonLatBox geojson_box_of(const Box2& box, const Plane& plane);

/// Returns "west,south,east,north" in degrees, with 4 decimals (about 10 m).
std::string text_of(const source::LonLatBox& box);

}  // namespace citykiln::map
