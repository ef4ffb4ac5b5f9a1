// Bakes the objects of a tile that are copies of shared meshes: plants and street lamps. Also bakes canopies (one
// surface over a closed wood) and tree pits (the open ground around a street tree).
//
// A prototype is one of the few distinct plants of a species, made once and placed many times; its number within the
// species is its variant.
#pragma once

#include "compiler/bake/baking.h"
#include "compiler/bake/prototype_cache.h"
#include "compiler/bake/tile_levels.h"

namespace citykiln::bake {

/// The plants, lamps and things of a tile, or of the baked part of it.
struct Placed {
  plants::PlacedPlants trees;
  Lamps lamps;
  std::vector<PlacedThing> things{};
  double left_out_m = 0;        ///< The largest distance of a point of a plant that was left out from the plant's foot.
  double drawn_left_out_m = 0;  ///< A bound of the heights of drawn things that are not at this level.
};

/// Returns the instances of a mesh, without its primitives.
/// @param size_m  The size of the mesh at a scale of 1.
InstancedMesh instances_of(const Baking& baking, const std::string& name, const std::vector<Placement>& placements,
                           double size_m);

/// Turns a copy so that its z axis, the vertical up to now, points in a direction other than straight down.
/// @param up  The direction, of unit length.
void tilt(InstancedMesh& instanced, std::size_t copy, Vec3 up);

/// Returns the plants, lamps and things that belong to the baked part. Plants of up to 2 m are left out where the
/// tolerance allows that, such as shrubs at 2.5 m.
/// @param common  Placed objects of the whole tile.
Placed placed_in(const Baking& baking, const SharedByLevels& common);

/// Replaces the trees of closed woods by one canopy surface, if the level has one (plants/prototypes/canopy.h). Parts
/// of a tile for a viewpoint have none, since each tree there has the tolerance of its distance.
void bake_canopy(Baking& baking, const TileLevel& level, Placed& placed);

/// Adds the features (map elements) of plants, lamps and things to the tile's features. Call it before the features are
/// sorted and numbered, and the bake functions below after that.
void add_features_of(Baking& baking, const Placed& placed);

/// The variant whose mesh replaces that of a prototype at a tolerance (plants::variants_at).
plants::Prototype merged_variant(plants::Prototype prototype, double tolerance_m);

/// Adds plants as instances of cached prototypes, with variants merged at the tolerance. If plants, lamps and things
/// together are more than `most_instances`, the plants of some map elements become single meshes (stands.h).
void bake_trees(Baking& baking, const Placed& placed, const PrototypeCache& prototypes, std::size_t most_instances);

/// The bounds of a tree pit on the ground.
Bounds bounds_of_pit(const props::TreePit& pit, const ground::GradedTerrain& graded);

/// Adds the tree pits that belong to the baked part: each is in the part in which its tree is.
void bake_tree_pits(Baking& baking, const SharedByLevels& common);

/// Adds street lamps as instances. Accounts "bake/lamp" (mapped lamps) and "bake/derived lamp" (lamps along lit
/// streets). Only mapped lamps are diagnosed when they are dropped.
void bake_lamps(Baking& baking, const Lamps& lamps, const ground::GradedTerrain& graded, Report& report);

}  // namespace citykiln::bake
