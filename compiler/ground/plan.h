// Stage 4: which surfaces cover the ground. Heights are the raw field's.
#pragma once

#include <vector>

#include "compiler/contract/report.h"
#include "compiler/ground/recipe.h"
#include "compiler/map/features.h"
#include "compiler/roads/generate.h"

namespace citykiln::ground {

/// Areas as surfaces, sorted by id. Roads, streams and buildings cover the ground too, but their strips and footprints
/// are made from their own recipes (surface_of). Ledger "ground/area". Total.
std::vector<LandCoverPolygon> plan(const map::Features& features, Report& report);

/// Waterways at ground level as strips, like roads, sorted by id. Ledger "ground/waterway". Total.
std::vector<roads::Strip> plan_streams(const map::Features& features, Report& report);

/// The axes of the others, in culverts and on aqueducts, sorted by id: the water goes on through them.
std::vector<Polyline> covered_waterways(const map::Features& features);

/// The surface that running water covers.
LandCoverPolygon surface_of(const roads::Strip& stream);
/// The surface that a road covers between its kerbs.
LandCoverPolygon surface_of(const roads::Road& road, const roads::StripEnds& ends);
/// What lies under that and shows beside it; without rings where nothing is raised there.
LandCoverPolygon pavement_of(const roads::Road& road, const roads::StripEnds& ends);

/// The surface with its rings trimmed to the box; rings that do not touch it are gone.
LandCoverPolygon trimmed_to(const LandCoverPolygon& surface, const Box2& box);

}  // namespace citykiln::ground
