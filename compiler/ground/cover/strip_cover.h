// Land cover polygons of roads and watercourses, and trimming of polygons to a box.
#pragma once

#include "compiler/geometry/box.h"
#include "compiler/ground/recipe.h"
#include "compiler/roads/generate.h"

namespace citykiln::ground {

/// Returns the polygon of running water.
LandCoverPolygon surface_of(const roads::Strip& stream);
/// Returns the polygon between a road's kerbs.
LandCoverPolygon surface_of(const roads::Road& road, const roads::StripEnds& ends);
/// Returns the polygon of a road with its raised edges, which shows beside the carriageway; without rings where nothing
/// is raised.
LandCoverPolygon pavement_of(const roads::Road& road, const roads::StripEnds& ends);

/// Returns the polygon with its rings trimmed to the box; rings that do not touch it are dropped.
LandCoverPolygon trimmed_to(const LandCoverPolygon& surface, const Box2& box);

}  // namespace citykiln::ground
