// Layers of a manifest for GIS: its recipes.
#pragma once

#include <string>

#include "compiler/commands/layers/layer.h"
#include "compiler/contract/result.h"
#include "compiler/scene/scene.h"

namespace citykiln::commands {

/// Returns the layer `name` (layer_names()) of a manifest, with heights: each object once, in however many chunks it
/// is. Areas end at the borders of the manifest's tiles, roads a few metres beyond. Junctions are those on the ground;
/// they do not overlap. Polygons are valid (OGC Simple Features). Error: an unknown name.
Result<Layer> layer_of(const scene::Scene& scene, const std::string& name);

}  // namespace citykiln::commands
