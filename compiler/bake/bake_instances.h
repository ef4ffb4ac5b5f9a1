// Trees and lamps: one mesh of a kind, and where it stands.
#pragma once

#include "compiler/bake/baking.h"
#include "compiler/bake/prototype_cache.h"
#include "compiler/bake/tile_levels.h"

namespace citykiln::bake {

/// What of the trees and lamps the firing holds.
struct Placed {
  plants::PlacedPlants trees;
  Lamps lamps;
};

Placed placed_in(const Baking& baking, const SharedByLevels& common);

/// One surface instead of trees, where they stand closed and the tolerance is coarse (plants/canopy.h). Not for one
/// eye: there each tree is as fine as it is near.
void bake_canopy(Baking& baking, const SharedByLevels& common, Placed& placed);

/// What is placed is named before features are numbered, and fired after.
void name_placed(Baking& baking, const Placed& placed);

/// Of the grove's shapes; variants that the tolerance does not tell apart (plants::variants_at) are one.
void bake_trees(Baking& baking, const plants::PlacedPlants& placed, const PrototypeCache& prototypes);

/// Those of trees that the firing holds: a pit goes with its tree.
void bake_tree_pits(Baking& baking, const SharedByLevels& common);

/// Accounts "bake/lamp", "bake/derived lamp". Only what somebody mapped is named where the tolerance drops it.
void bake_lamps(Baking& baking, const Lamps& lamps, const ground::GradedTerrain& graded, Report& report);

}  // namespace citykiln::bake
