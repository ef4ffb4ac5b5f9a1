// The scene that `preview` renders: baked tiles, or the recipes of a manifest.
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compiler/commands/view/load_cells.h"
#include "compiler/commands/view/load_tiles.h"
#include "compiler/commands/view/view_options.h"
#include "preview/light/fog.h"
#include "preview/light/surroundings.h"
#include "preview/scene/lamps.h"
#include "preview/scene/lit_panes.h"
#include "preview/scene/world.h"

namespace citykiln::commands {

/// Surfaces, sky and lights for rendering.
struct PreviewScene {
  Loaded loaded;                          ///< Without tiles if there are recipes.
  std::optional<scene::Scene> recipes{};  ///< The recipes of a manifest, whose cells are generated when rays meet them.
  std::vector<bake::BakedTile> for_views{};  ///< Tiles at about 2.5 m from which views are chosen; empty: use `loaded`.
  std::optional<TileTree> tree{};            ///< The levels of a folder, until load_levels().
  sky::Sky sky{};
  std::vector<preview::StreetLamp> lamps{};       ///< The lamps that are lit.
  std::optional<preview::Surroundings> around{};  ///< From the manifest, or the one beside the tiles.
  std::optional<bake::BakedTile> backdrop{};      ///< The land around the scene, if a heightmap covers it.
  Box2 clear{};                                   ///< preview::Backdrop::clear.
  std::optional<preview::Surroundings> plain{};   ///< Replaces `around` and `backdrop` (leave_out_hiding_land()).
  std::optional<preview::Fog> fog{};              ///< With a manifest, if requested.
  /// The tiles inside of their cylinder, after bend_tiles(); all other members are in the plane.
  std::vector<bake::BakedTile> bent{};
  std::string note{};  ///< One line about what is rendered instead of what was asked for; "" for none.
  std::vector<preview::LitPane> panes{};  ///< At night, the lit windows of recipes near the cameras.

  std::size_t tiles() const { return recipes ? recipes->chunks.size() : std::max(loaded.tiles.size(), bent.size()); }
  /// Returns the tiles from which views are chosen. With a manifest, or a folder that has a level of 2.5 m, they do not
  /// depend on the level that is rendered.
  std::span<const bake::BakedTile> view_tiles() const {
    if (tree) return tree->coarse;
    return for_views.empty() ? std::span<const bake::BakedTile>(loaded.tiles) : for_views;
  }
  /// Returns the height of the ground at a place, of the finest level; empty outside the tiles.
  std::optional<double> ground_height_m(Vec2 place) const;

 private:
  mutable std::map<std::string, bake::BakedTile> ground_tiles_{};  // tiles of `tree` that were read for heights
};

/// The parts of a scene that a command needs.
struct SceneRequest {
  LoadRequest load;
  CellRequest cells;
  bool finds_views = true;            ///< True if view_tiles() are needed.
  bool needs_tiles = false;           ///< True: a manifest is baked even if no tolerance is given.
  std::optional<double> fog_share{};  ///< The fog reaches the height below which this share of the ground lies.
};

/// Loads the scene of a request. Errors: those of load_tiles(); a time that does not parse.
Result<PreviewScene> load_preview_scene(const SceneRequest& request, const OnProgress& on_progress);

/// Reads the tiles of `scene.tree`: for each place the coarsest level whose error is at most the pixel error in every
/// picture; without cameras the finest level. If there is none for some place, and the manifest is beside the tiles,
/// the scene gets its recipes instead, and a note says so. Then sets sky and lamps. Does nothing for other scenes.
/// Errors: files that cannot be read.
Result<Done> load_levels(PreviewScene& scene, const SceneRequest& request, const Viewing& viewing,
                         const OnProgress& on_progress);

/// Bends tiles, lamps and cameras into the cylinder of the scene, where it is in one. Sets PreviewScene::bent.
void bend_tiles(PreviewScene& scene);

/// Removes the land around the tiles if it would hide them from a camera outside the tiles (hidden_by_land.h). Returns
/// true if it was removed. Named views are chosen without regard to the land around.
bool leave_out_hiding_land(PreviewScene& scene, std::span<const preview::Camera> cameras);

/// Returns one line with the number of tiles at each tolerance.
std::string levels_text(std::span<const bake::BakedTile> tiles);

/// Returns the surfaces for rays from cameras. Cells of recipes are as fine as the cameras need; tiles are the same for
/// all cameras. Refers to the scene, which must outlive it.
preview::World world_of(const PreviewScene& scene, const Viewing& viewing, const CellRequest& cells);

}  // namespace citykiln::commands
