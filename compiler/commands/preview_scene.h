// The scene that preview renders: baked tiles, or the recipes of a manifest.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "compiler/commands/load_cells.h"
#include "compiler/commands/load_tiles.h"
#include "compiler/commands/view_options.h"
#include "preview/light/fog.h"
#include "preview/light/surroundings.h"
#include "preview/scene/lamps.h"
#include "preview/scene/world.h"

namespace citykiln::commands {

struct PreviewScene {
  Loaded loaded;                             ///< Without tiles where there are recipes.
  std::optional<scene::Scene> recipes{};     ///< Of a manifest whose cells are generated when rays meet them.
  std::vector<bake::BakedTile> for_views{};  ///< Tiles at some 2.5 m from which views are found; empty: use `loaded`.
  sky::Sky sky{};
  std::vector<preview::StreetLamp> lamps{};       ///< Lit ones.
  std::optional<preview::Surroundings> around{};  ///< Of a manifest.
  std::optional<preview::Fog> fog{};              ///< Of a manifest, if asked for.

  std::size_t tiles() const { return recipes ? recipes->chunks.size() : loaded.tiles.size(); }
  /// The tiles from which views are found. With a manifest, or a folder that has a level of 2.5 m, they do not depend
  /// on the level that is rendered.
  std::span<const bake::BakedTile> view_tiles() const {
    return for_views.empty() ? std::span<const bake::BakedTile>(loaded.tiles) : for_views;
  }
  std::optional<double> ground_height_m(Vec2 place) const;
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

/// The scene for rays from a camera: of recipes, cells as fine as the camera needs; of tiles, the same for all cameras.
/// Refers to the scene, which must outlive it.
preview::World world_of(const PreviewScene& scene, const preview::Camera& camera, int height_px,
                        const CellRequest& cells);

}  // namespace citykiln::commands
