// Bakes the instanced objects of a tile, which are plants and street lamps; also canopies and tree pits.
#pragma once

#include "compiler/bake/baking.h"
#include "compiler/bake/prototype_cache.h"
#include "compiler/bake/tile_levels.h"

namespace citykiln::bake {

/// The placements in a tile or in a part of it.
struct Placed {
  plants::PlacedPlants trees;
  Lamps lamps;
};

Placed placed_in(const Baking& baking, const SharedByLevels& common);

/// Replaces the trees of closed woods by one canopy surface, if the level has one (plants/prototypes/canopy.h). Parts
/// of a view have none, since in a view each tree has the tolerance of its distance.
void bake_canopy(Baking& baking, const TileLevel& level, Placed& placed);

/// Adds the features of placed objects. Call it before features are numbered; call the functions below after that.
void name_placed(Baking& baking, const Placed& placed);

/// The variant that replaces a prototype at a tolerance (plants::variants_at).
plants::Prototype merged_variant(plants::Prototype prototype, double tolerance_m);

/// Adds plants as instances of cached prototypes. Variants that look alike at the tolerance (plants::variants_at) are
/// merged. If there are more than `most_instances`, lamps included, stands become single meshes (stands.h).
void bake_trees(Baking& baking, const Placed& placed, const PrototypeCache& prototypes, std::size_t most_instances);

/// The bounds of a tree pit on the ground.
Bounds bounds_of_pit(const props::TreePit& pit, const ground::GradedTerrain& graded);

/// Adds the tree pits. A pit is in the part of a view in which its tree is.
void bake_tree_pits(Baking& baking, const SharedByLevels& common);

/// Adds street lamps as instances. Accounts "bake/lamp" and "bake/derived lamp". Only dropped lamps that are mapped are
/// diagnosed.
void bake_lamps(Baking& baking, const Lamps& lamps, const ground::GradedTerrain& graded, Report& report);

}  // namespace citykiln::bake
