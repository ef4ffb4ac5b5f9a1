// Land on which nothing may stand.
#pragma once

#include "compiler/ground/cover/land_cover_index.h"

namespace citykiln::verify {

/// Returns the land cover on top at a place if it is a road, a railway, a building or water, else null. Pedestrian
/// streets are allowed: trees, lamps and things stand on them. O(1) expected.
const ground::LandCoverPolygon* taken_land_at(const ground::LandCoverIndex& land_cover, Vec2 p);

/// Returns the element of taken_land_at(); OsmType::kNone if the place is free.
OsmId taken_element_at(const ground::LandCoverIndex& land_cover, Vec2 p);

}  // namespace citykiln::verify
