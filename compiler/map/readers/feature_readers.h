// Reads the features of the map, one function for each kind, for locate(). Each keeps an account "map/<kind>" in the
// ledger.
#pragma once

#include <vector>

#include "compiler/map/cross_section.h"
#include "compiler/map/features.h"
#include "compiler/map/tags/read_context.h"

namespace citykiln::map {

/// Reads ways that have a row in track_rules.inc, their lanes (lanes.h) and their marked nodes (track_points.h).
/// @param side  The driving side; if empty, driving_side_at() the first node of each way.
std::vector<Track> locate_tracks(const ReadContext& context, std::optional<DrivingSide> side);
std::vector<Footprint> locate_footprints(const ReadContext& context);  ///< building=*, building:part=*.
/// Returns the areas of area_rules.inc, without the sea. Pools that lie in one of the footprints are dropped,
/// kInsideBuilding.
std::vector<AreaFeature> locate_areas(const ReadContext& context, const std::vector<Footprint>& footprints = {});
/// True for a closed way that is a line by its tags (a road, a hedge, a coast) unless area=yes.
bool is_closed_line(const ReadContext& context, source::Range tags, OsmType type);
/// Returns leisure=pitch with sport=*, among areas that are read. They are not counted: each is an area.
std::vector<SportsArea> locate_sports_areas(const ReadContext& context, const std::vector<AreaFeature>& areas);

/// The sea of the extent, and the coastlines that bound it.
struct LocatedSea {
  std::vector<AreaFeature> areas;  ///< Closed around the extent.
  std::vector<Polyline> coasts;    ///< Features::coasts.
};
/// Reads natural=coastline. Ledger "map/coastline".
LocatedSea locate_sea(const ReadContext& context);
std::vector<Waterway> locate_waterways(const ReadContext& context);   ///< waterway=* lines.
std::vector<Barrier> locate_barriers(const ReadContext& context);     ///< barrier=* lines.
std::vector<Landform> locate_landforms(const ReadContext& context);   ///< Retaining walls, cliffs, dykes, piers, …
std::vector<PointFeature> locate_points(const ReadContext& context);  ///< Trees, lamps and similar.
std::vector<TreeRow> locate_tree_rows(const ReadContext& context);    ///< natural=tree_row lines.
std::vector<PowerLine> locate_power_lines(
    const ReadContext& context);  ///< power=line and minor_line above the ground; aerialways.

}  // namespace citykiln::map
