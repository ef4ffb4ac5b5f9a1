// Plans land cover without heights: polygons of mapped areas, and watercourses as strips. A strip is an axis with a
// width on each side. Both are recipes: plain data from which the ground is generated later. Objects are counted in the
// ledger, a list of accounts of the objects that go into a stage, come out of it or are dropped
// (contract/findings/report.h).
#pragma once

#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/ground/cover/strip_cover.h"
#include "compiler/ground/recipe.h"
#include "compiler/map/features.h"
#include "compiler/roads/generate.h"

namespace citykiln::ground {

/// Returns the polygon of an area, without a raised priority.
LandCoverPolygon surface_of(const map::AreaFeature& area);

/// Returns mapped areas as polygons, sorted by id. Polygons of roads, watercourses and buildings come from their own
/// recipes. Ledger "ground/area".
std::vector<LandCoverPolygon> plan(const map::FeatureView& features, Report& report);

/// Returns waterways at ground level as strips, sorted by id, as wide as grown_widths_m(). Ledger "ground/waterway".
std::vector<roads::Strip> plan_streams(const map::FeatureView& features, Report& report);

/// Returns the axes of waterways in culverts and on aqueducts, sorted by id, directed downstream. They connect rivers.
std::vector<Polyline> covered_waterways(const map::FeatureView& features);

}  // namespace citykiln::ground
