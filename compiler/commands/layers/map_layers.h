// Layers of a map for GIS: its elements after they are located and classified, before planning.
#pragma once

#include <string>

#include "compiler/commands/layers/layer.h"
#include "compiler/contract/result.h"
#include "compiler/map/features.h"

namespace citykiln::commands {

/// Returns the layer `name` (layer_names()) of a map, without heights: each object once. Areas end at the border of the
/// extent. Junctions of bridges and tunnels follow those of the ground. Polygons are valid (OGC Simple Features).
/// Error: an unknown name.
Result<Layer> layer_of(const map::Features& features, const std::string& name);

}  // namespace citykiln::commands
