// Makes land cover polygons of roads and watercourses, and trims polygons to a box. A strip is a piece of ground along
// an axis.
#pragma once

#include "compiler/geometry/box.h"
#include "compiler/ground/recipe.h"
#include "compiler/roads/generate.h"

namespace citykiln::ground {

/// Returns the polygon of a watercourse.
LandCoverPolygon surface_of(const roads::Strip& stream);
/// Returns the polygon between a road's kerbs.
/// @param ends  Connections to other roads at both ends.
LandCoverPolygon surface_of(const roads::Road& road, const roads::StripEnds& ends);
/// Returns the polygon of a road with its pavements and other raised lanes, of which the part beside the carriageway is
/// visible. It has no rings if the road has no raised lanes.
LandCoverPolygon pavement_of(const roads::Road& road, const roads::StripEnds& ends);

/// Returns the polygon with its rings trimmed to the box; rings that do not touch it are dropped.
LandCoverPolygon trimmed_to(const LandCoverPolygon& surface, const Box2& box);

}  // namespace citykiln::ground
