// Layers of a map for GIS: its elements after they are located and classified, before planning.
#pragma once

#include <string>

#include "compiler/commands/layers/layer.h"
#include "compiler/contract/result.h"
#include "compiler/map/features.h"

namespace citykiln::commands {

/// Returns a layer of a map, without heights, each object once. Areas end at the border of the extent. Junctions of
/// bridges and tunnels follow the junctions on the ground. Polygons are valid (OGC Simple Features). Error: an unknown
/// name.
/// @param name  One of layer_names().
Result<Layer> layer_of(const map::Features& features, const std::string& name);

}  // namespace citykiln::commands
