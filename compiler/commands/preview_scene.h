// The scene that preview renders: baked tiles, or the recipes of a manifest.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compiler/commands/load_cells.h"
#include "compiler/commands/load_tiles.h"
#include "compiler/commands/view_options.h"
#include "preview/light/fog.h"
#include "preview/light/surroundings.h"
#include "preview/scene/lamps.h"
#include "preview/scene/lit_panes.h"
#include "preview/scene/world.h"

namespace citykiln::commands {

struct PreviewScene {
  Loaded loaded;                             ///< Without tiles where there are recipes.
  std::optional<scene::Scene> recipes{};     ///< Of a manifest whose cells are generated when rays meet them.
  std::vector<bake::BakedTile> for_views{};  ///< Tiles at some 2.5 m from which views are found; empty: use `loaded`.
  std::optional<TileTree> tree{};            ///< Of a folder, until load_levels().
  sky::Sky sky{};
  std::vector<preview::StreetLamp> lamps{};       ///< Lit ones.
  std::optional<preview::Surroundings> around{};  ///< Of a manifest, or of the one beside the tiles.
  std::optional<bake::BakedTile> backdrop{};      ///< The land around, where a heightmap knew it.
  Box2 clear{};                                   ///< preview::Backdrop::clear.
  std::optional<preview::Surroundings> plain{};   ///< What replaces `around` and `backdrop` (leave_out_hiding_land()).
  std::optional<preview::Fog> fog{};              ///< Of a manifest, if asked for.
  std::vector<preview::LitPane> panes{};          ///< By night, of recipes near the cameras.

  std::size_t tiles() const { return recipes ? recipes->chunks.size() : loaded.tiles.size(); }
  /// The tiles from which views are found. With a manifest, or a folder that has a level of 2.5 m, they do not depend
  /// on the level that is rendered.
  std::span<const bake::BakedTile> view_tiles() const {
    if (tree) return tree->coarse;
    return for_views.empty() ? std::span<const bake::BakedTile>(loaded.tiles) : for_views;
  }
  /// Of the finest level.
  std::optional<double> ground_height_m(Vec2 place) const;

 private:
  mutable std::map<std::string, bake::BakedTile> ground_tiles_{};  // of `tree`, last asked for
};

struct SceneRequest {
  LoadRequest load;
  CellRequest cells;
  bool finds_views = true;            ///< Whether view_tiles() are needed.
  bool needs_tiles = false;           ///< Bakes a manifest even if no tolerance is given.
  std::optional<double> fog_share{};  ///< Fog up to the height below which this share of the ground is.
};

/// Errors: those of load_tiles(), and a time that is not one.
Result<PreviewScene> load_preview_scene(const SceneRequest& request, const OnProgress& on_progress);

/// Reads the tiles of `scene.tree`, each at the coarsest level whose error is not longer than the pixel error in any
/// picture; without cameras the finest. Sets sky and lamps. Does nothing for other scenes. Errors: those of reading.
Result<Done> load_levels(PreviewScene& scene, const SceneRequest& request, const Viewing& viewing,
                         const OnProgress& on_progress);

/// Leaves out the land around where it would hide the scene: a camera outside of the tiles is below it, or it is
/// between a camera and the place in the tiles that it looks at. Returns whether it does. Views are chosen for the
/// tiles alone.
bool leave_out_hiding_land(PreviewScene& scene, std::span<const preview::Camera> cameras);

/// One line: how many tiles have which tolerance.
std::string levels_text(std::span<const bake::BakedTile> tiles);

/// The scene for rays from cameras: of recipes, cells as fine as the cameras need; of tiles, the same for all cameras.
/// Refers to the scene, which must outlive it.
preview::World world_of(const PreviewScene& scene, const Viewing& viewing, const CellRequest& cells);

}  // namespace citykiln::commands
