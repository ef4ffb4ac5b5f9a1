// The layer of lots of a map, for GIS.
#pragma once

#include <span>

#include "compiler/commands/layers/layer.h"
#include "compiler/map/features.h"
#include "compiler/map/plane/plane.h"

namespace citykiln::commands {

/// Returns the lots with buildings as polygons: their id is that of the main building, their class the kind of lot
/// ("Detached"). They are planned as compile plans them with all assumptions about roads.
/// @param private_ways  Sorted (map/ways/private_ways.h).
Layer lots_layer(const map::FeatureView& mapped, std::span<const OsmId> private_ways, const map::Plane& plane);

}  // namespace citykiln::commands
