// Bakes things (benches, bollards, signs) as instances of meshes that all things of a form share.
#pragma once

#include "compiler/bake/baking.h"
#include "compiler/bake/place_things.h"
#include "compiler/bake/prototype_cache.h"

namespace citykiln::bake {

/// Adds things as instances. Account "bake/thing". Rules that ask for something impossible are diagnosed,
/// kThingRuleErrors, once for each form and tile.
void bake_things(Baking& baking, const std::vector<PlacedThing>& things, const PrototypeCache& prototypes,
                 Report& report);

}  // namespace citykiln::bake
