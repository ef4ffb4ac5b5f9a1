// Layers for GIS of a manifest (a compiled scene): its roads, junctions, areas, buildings or plants as features.
#pragma once

#include <string>

#include "compiler/commands/layers/layer.h"
#include "compiler/contract/result.h"
#include "compiler/scene/scene.h"

namespace citykiln::commands {

/// Returns a layer of a manifest, with heights. Each object is one feature, even if several chunks hold it. Areas end
/// at the borders of the manifest's tiles, roads a few metres beyond. Only junctions on the ground are included; they
/// do not overlap. Polygons are valid (OGC Simple Features). Error: an unknown name.
/// @param name  One of layer_names().
Result<Layer> layer_of(const scene::Scene& scene, const std::string& name);

}  // namespace citykiln::commands
