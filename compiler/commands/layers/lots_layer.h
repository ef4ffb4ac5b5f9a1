// The layer of lots of a map, for GIS.
#pragma once

#include <span>

#include "compiler/commands/layers/layer.h"
#include "compiler/map/features.h"
#include "compiler/map/plane/plane.h"

namespace citykiln::commands {

/// Returns the lots with buildings as polygons in plane metres. The id of a lot is that of its main building
/// (Lot::main), its class the kind of lot ("Detached"). Lots are planned as compile plans them with all assumptions
/// about roads.
///
/// @param private_ways  Sorted (map/ways/private_ways.h).
/// @param plane         The plane of `mapped`; the climate is looked up by longitude and latitude.
Layer lots_layer(const map::FeatureView& mapped, std::span<const OsmId> private_ways, const map::Plane& plane);

}  // namespace citykiln::commands
