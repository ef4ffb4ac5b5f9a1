// Layers of a manifest: its recipes, as planned.
#pragma once

#include <string>

#include "compiler/commands/layer.h"
#include "compiler/contract/result.h"
#include "compiler/scene/scene.h"

namespace citykiln::commands {

/// Returns the layer `name` (layer_names()) of a manifest, with heights: each object once, whatever tiles hold it.
/// Areas end at the borders of the tiles that the manifest has; roads end a few metres beyond. Junctions are those on
/// the ground, without area in common. Polygons are valid (OGC Simple Features). Error: an unknown name.
Result<Layer> layer_of(const scene::Scene& scene, const std::string& name);

}  // namespace citykiln::commands
