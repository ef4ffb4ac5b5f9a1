// The formats of outlines: GeoJSON, and the polygons of Osmosis.
#pragma once

#include <string>
#include <string_view>

#include "compiler/source/outline.h"

namespace citykiln::source {

/// Parses GeoJSON (RFC 7946): a Polygon or MultiPolygon, alone or in Features and collections; other geometries are
/// skipped. Errors name the file and the member: malformed JSON, a ring that is not closed, coordinates that are no
/// numbers, another coordinate system than WGS84, no polygon. Other properties of polygons are not checked.
Result<Outline> parse_geojson_outline(std::string_view text, const std::string& name);

/// Parses the polygon filter format of Osmosis: a title, then sections of a name, lines with longitude and latitude,
/// and END; a name that begins with "!" is a hole of the outer ring around its first point. END ends the file. Errors
/// name the line.
Result<Outline> parse_poly_outline(std::string_view text, const std::string& name);

}  // namespace citykiln::source
