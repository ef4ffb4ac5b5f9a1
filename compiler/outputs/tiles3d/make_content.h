// Makes the contents of a tile tree from baked tiles.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/bake/place_lamps.h"
#include "compiler/outputs/texture_choice.h"
#include "compiler/outputs/tiles3d/plan_tree.h"
#include "compiler/outputs/tiles3d/tree_world.h"
#include "compiler/spec.h"

namespace citykiln::outputs {

/// The scene of a tree, its plan, and how its contents look. All must outlive it.
struct TreeContents {
  const scene::Scene& scene;
  const Outputs& outputs;
  const TreeWorld& world;
  const TreePlan& plan;
  const TextureChoice& textures;
};

/// Returns the .glb of a baked tile, bent into the tree's world. Changes nothing that calls share; thread-safe.
/// @param lights  The lamps that become lights of the content, as lights_of() returns them: in the plane, or bent
///                already if the world is the inside of a cylinder.
std::vector<std::byte> make_content(const TreeContents& tree, bake::BakedTile&& baked,
                                    const std::vector<bake::PlacedLamp>& lights, int threads);

/// Prepares a baked tile to be joined into an inner node by make_inner_tile(). Where the tolerance of that level pays
/// for it, the tile's terrain is decimated by at most kSimplifyShare of the tolerance. Vertices on the tile's border
/// stay, so that parts made at the same time meet. In the plane, not bent. Thread-safe.
/// @param height  The level of the inner node in the quadtree (NodeKey::height), at least 1; not metres.
/// @param baked   The tile at the tolerance InnerLevel::bake_m of that level. Consumed.
bake::BakedTile make_part(const TreeContents& tree, int height, scene::TileKey tile, bake::BakedTile&& baked);

/// Returns the tile of an inner node in the plane: its parts as one tile. Parts that are inner nodes are simplified.
/// @param parts  In the order of the plan: the results of make_part() for InnerNode::chunks, or, if the height has no
///               InnerLevel::bake_m, the results for InnerNode::children.
/// Errors: those of bake::join_tiles() (bake/tiles/join_tiles.h).
Result<bake::BakedTile> make_inner_tile(const TreeContents& tree, exporters::NodeKey key,
                                        std::span<const bake::BakedTile> parts);

/// The land around a scene as a content, and its tile in the tree.
struct AroundContent {
  std::vector<std::byte> glb;
  exporters::TilesetTile tile;
};

/// Bakes the land around; empty if the header has none. Cost: half a second.
std::optional<AroundContent> make_surroundings(const TreeContents& tree, int threads);

/// Returns a root without content above the scene's root and the land around, so that both are shown.
exporters::TilesetTile with_surroundings(exporters::TilesetTile root, exporters::TilesetTile around);

}  // namespace citykiln::outputs
