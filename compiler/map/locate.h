// Locates features: converts elements with longitudes, latitudes and tags into features of the plane.
#pragma once

#include <optional>

#include "compiler/contract/findings/report.h"
#include "compiler/map/features.h"
#include "compiler/map/plane/plane.h"
#include "compiler/map/plants/user_plants.h"
#include "compiler/map/things/thing_table.h"
#include "compiler/source/osm_data.h"

namespace citykiln::map {

/// Settings of locate() and choose_box().
struct Options {
  std::optional<source::LonLatBox> bbox;    ///< The box to compile. Default: the map's own box (map_box.h).
  std::optional<LonLat> origin;             ///< Origin of the plane. Default: the box's centre, rounded to 0.01°.
  std::optional<DrivingSide> driving_side;  ///< Default: driving_side_at() the first node of each way.
  const ThingTable* things = nullptr;       ///< The things that are read; null: none.
  const UserPlants* user_plants = nullptr;  ///< User-defined plants; null: none.
  bool keeps_tags = false;                  ///< True if Features::texts shall have all tags of each element.
};

/// Returns options.bbox, else the map's own box, in degrees. An empty extract gives a box of zero size at 0, 0.
source::LonLatBox choose_box(const source::OsmData& osm, const Options& options);

/// Returns the default origin of a box: its centre, rounded to 0.01°.
LonLat default_origin(const source::LonLatBox& box);

/// Returns the extent for a box in degrees: the box, in the plane, of all cells of kCell_m (128 m) that it touches.
Box2 extent_of(const Plane& plane, const source::LonLatBox& box);

/// Puts every element into the plane and reads its tags by the tables of the .inc files.
///
/// Elements without a row in a table, outside the extent, or without length or area are dropped and diagnosed. Ledger
/// "map/track", "map/footprint", "map/area", "map/coastline", "map/waterway", "map/barrier", "map/landform",
/// "map/point", "map/thing", "map/tree row", "map/power", "map/aerialway", "map/unread". Cannot fail. O(n log n) in
/// nodes; coastlines: close_sea().
Features locate(const source::OsmData& osm, const Plane& plane, const source::LonLatBox& box, const Options& options,
                Report& report);

}  // namespace citykiln::map
