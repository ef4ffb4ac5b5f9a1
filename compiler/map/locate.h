// Locates features: from longitude, latitude and tags to features of the plane.
#pragma once

#include <optional>

#include "compiler/contract/report.h"
#include "compiler/map/features.h"
#include "compiler/map/plane.h"
#include "compiler/source/osm_data.h"

namespace citykiln::map {

struct Options {
  std::optional<source::LonLatBox> bbox;    ///< Else the map's own box (map_box.h).
  std::optional<LonLat> origin;             ///< Else the centre of the box, rounded to 0.01°.
  std::optional<DrivingSide> driving_side;  ///< Else each way's by the place of its first node (driving_side.h).
  bool keeps_tags = false;                  ///< Whether Features::texts have all tags of each element.
};

/// Returns the box asked for, else the map's, in degrees. Total: an empty extract gives a box of zero size at 0, 0.
source::LonLatBox choose_box(const source::OsmData& osm, const Options& options);

/// Returns the default origin of a box: its centre, rounded to 0.01°.
LonLat default_origin(const source::LonLatBox& box);

/// Returns the region of a box: the cells of kCell_m that contain it.
Box2 region_of(const Plane& plane, const source::LonLatBox& box);

/// Puts every element into the plane and reads its tags by the tables of the .inc files.
///
/// Elements without a row, outside the region or without extent are dropped and diagnosed. Ledger "map/track",
/// "map/footprint", "map/area", "map/coastline", "map/waterway", "map/barrier", "map/point", "map/tree row",
/// "map/power". Total. O(n) in nodes, O(n log n) in coastlines.
Features locate(const source::OsmData& osm, const Plane& plane, const source::LonLatBox& box, const Options& options,
                Report& report);

}  // namespace citykiln::map
