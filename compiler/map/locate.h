// Stage 2: from longitude, latitude and tags to features and heights in the plane.
#pragma once

#include <optional>
#include <span>

#include "compiler/contract/report.h"
#include "compiler/contract/result.h"
#include "compiler/map/features.h"
#include "compiler/map/plane.h"
#include "compiler/source/raster.h"

namespace citykiln::map {

/// Cells of the ground: the region and every tile are made of these.
inline constexpr double kCell_m = 128;

struct Options {
  std::optional<source::LonLatBox>
      bbox;  ///< What to compile; else the extract's header box, else the box of its roads and buildings.
  std::optional<LonLat> origin;             ///< Else the centre of the box, rounded to 0.01°.
  std::optional<DrivingSide> driving_side;  ///< Else each way's by the place of its first node (driving_side.h).
};

/// The box that is compiled, in degrees. Total: an empty extract gives a box of zero size at 0, 0.
source::LonLatBox choose_box(const source::OsmData& osm, const Options& options);

/// The default origin of a box: its centre, rounded to 0.01°.
LonLat default_origin(const source::LonLatBox& box);

/// Puts every element into the plane and reads its tags, by the tables in surface_rules.inc and its neighbours.
/// Total. Ledger "map/track", "map/footprint", "map/area", "map/waterway", "map/barrier", "map/point",
/// "map/tree row", "map/power": what no row
/// knows, what lies outside the region, and what has no extent is dropped and diagnosed. Cost: linear in nodes, but for
/// coastlines (sorted by place along the region's border).
Features locate(const source::OsmData& osm, const Plane& plane, const source::LonLatBox& box, const Options& options,
                Report& report);

/// Resamples the rasters (voids already filled, first raster wins where several cover a place) into one field over
/// `region` and one step beyond. Without rasters the field is flat at 0. Places that no raster covers take the nearest
/// height, diagnosed kNoHeight. The steps, east and north, are the largest whole multiples of kStepUnit_m that are not
/// above the finest spacing of a raster that way (at least 1 m, at most kCell_m). In the middle of the region vertices
/// lie on samples of the first raster that covers it; farther off, where degrees and metres run apart, between them.
Result<Heightfield> resample(std::span<const source::Raster> rasters, const Plane& plane, const Box2& region,
                             Report& report);

}  // namespace citykiln::map
