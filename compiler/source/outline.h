// An outline: polygons in degrees that a map is clipped to, read from a file or taken from an area of the map.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/geometry/lonlat.h"
#include "compiler/source/osm_data.h"

namespace citykiln::source {

using LonLatRing = std::vector<LonLat>;

/// A polygon in degrees. The last point of a ring is not the first one again. Rings run in any direction.
struct LonLatPolygon {
  LonLatRing outer;
  std::vector<LonLatRing> holes{};
  bool operator==(const LonLatPolygon&) const = default;
};

/// Polygons that together are one outline.
struct Outline {
  std::string where;  ///< The name in errors: a file, or an area of the map.
  std::vector<LonLatPolygon> polygons;
  bool operator==(const Outline&) const = default;
};

/// Reads polygons: of GeoJSON (Polygon, MultiPolygon, and Features, FeatureCollections and GeometryCollections of them)
/// in files that end in .json or .geojson, else in the format of Osmosis (.poly).
///
/// Errors, each with the file and the place in it: a file that cannot be read, another format, no polygon, a ring that
/// has fewer than three different points, is not closed (GeoJSON), crosses or touches itself, or crosses or overlaps
/// another ring, an edge of more than 90° of longitude, a hole outside of its outer ring, longitudes beyond ±360° and
/// latitudes beyond ±90°. Different rings may touch at single points. Cost: O(n log n) in points, more if many edges
/// lie above each other.
Result<Outline> read_outline(const std::string& path);

/// Parses the text of such a file. `name` is what errors name, and decides the format.
Result<Outline> parse_outline(std::string_view text, const std::string& name);

/// Checks rings as read_outline() does. Its errors name polygon and point by number, from 1.
Result<Done> check_outline(const Outline& outline);

/// Returns the box of an outline, in degrees; its polygons must not be empty.
LonLatBox box_of(const Outline& outline);

}  // namespace citykiln::source
