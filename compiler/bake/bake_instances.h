// Instanced objects of a tile: plants, street lamps; and what goes with them: canopies, tree pits.
#pragma once

#include "compiler/bake/baking.h"
#include "compiler/bake/prototype_cache.h"
#include "compiler/bake/tile_levels.h"

namespace citykiln::bake {

/// The placements that a tile, or a part of it, holds.
struct Placed {
  plants::PlacedPlants trees;
  Lamps lamps;
};

Placed placed_in(const Baking& baking, const SharedByLevels& common);

/// Replaces the trees of closed woods by one canopy surface where the level has one (plants/prototypes/canopy.h). Parts
/// of a view have none, since there each tree has the tolerance of its distance.
void bake_canopy(Baking& baking, const TileLevel& level, Placed& placed);

/// Adds the features of placed objects; call before features are numbered, and the functions below after.
void name_placed(Baking& baking, const Placed& placed);

/// The variant that stands for a prototype at a tolerance (plants::variants_at).
plants::Prototype merged_variant(plants::Prototype prototype, double tolerance_m);

/// Adds plants as instances of cached prototypes. Variants that look alike at the tolerance (plants::variants_at) are
/// merged. Where there are more than `most_instances`, lamps included, stands become single meshes (stands.h).
void bake_trees(Baking& baking, const Placed& placed, const PrototypeCache& prototypes, std::size_t most_instances);

/// The bounds of a tree pit on the ground.
Bounds bounds_of_pit(const props::TreePit& pit, const ground::GradedTerrain& graded);

/// Adds the tree pits; a pit is in the part of its tree.
void bake_tree_pits(Baking& baking, const SharedByLevels& common);

/// Adds street lamps as instances. Accounts "bake/lamp" and "bake/derived lamp"; of dropped lamps only mapped ones are
/// diagnosed.
void bake_lamps(Baking& baking, const Lamps& lamps, const ground::GradedTerrain& graded, Report& report);

}  // namespace citykiln::bake
