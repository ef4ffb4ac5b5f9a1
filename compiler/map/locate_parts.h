// One reader a kind of feature; locate() calls them in turn. Each keeps its own account in the ledger, "map/<kind>".
#pragma once

#include <vector>

#include "compiler/map/features.h"
#include "compiler/map/lanes/lanes.h"
#include "compiler/map/osm_reader.h"

namespace citykiln::map {

/// By track_rules.inc, lanes.h and track_points.h. Without a side each way drives as its first node's place does.
std::vector<Track> locate_tracks(const Reading& reading, std::optional<DrivingSide> side);
std::vector<Footprint> locate_footprints(const Reading& reading);  ///< building=*, building:part=*.
std::vector<AreaFeature> locate_areas(const Reading& reading);     ///< By area_rules.inc; without the sea.
std::vector<AreaFeature> locate_sea(
    const Reading& reading);  ///< natural=coastline, closed along the region. Ledger "map/coastline".
std::vector<Waterway> locate_waterways(const Reading& reading);     ///< waterway=* lines.
std::vector<Barrier> locate_barriers(const Reading& reading);       ///< barrier=* lines.
std::vector<PointFeature> locate_points(const Reading& reading);    ///< Trees, lamps and the like.
std::vector<TreeRow> locate_tree_rows(const Reading& reading);      ///< natural=tree_row lines.
std::vector<PowerLine> locate_power_lines(const Reading& reading);  ///< power=line, minor_line above the ground.

}  // namespace citykiln::map
