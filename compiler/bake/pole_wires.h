// Hangs wires between the utility poles of a tile's streets (furniture/utility_poles.h), which have no recipes.
#pragma once

#include <span>
#include <vector>

#include "compiler/bake/place_generated.h"
#include "compiler/bake/prototype_cache.h"
#include "compiler/wires/recipe.h"

namespace citykiln::bake {

/// Returns the wires of spans: one on each insulator, and below them a thicker telephone cable at 6.25 m.
/// @param prototypes  The cache whose rules state where wires hang.
std::vector<wires::WireSpan> wires_of(std::span<const PlacedPoleSpan> spans, const PrototypeCache& prototypes);

}  // namespace citykiln::bake
