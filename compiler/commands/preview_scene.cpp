#include "compiler/commands/preview_scene.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "compiler/commands/ground_height.h"
#include "compiler/commands/requested_sky.h"
#include "compiler/commands/scene_surroundings.h"
#include "compiler/verify/run_report.h"

namespace citykiln::commands {
namespace {

// The tolerance of the tiles from which views are found: coarse enough to be quick, fine enough for streets and walls.
constexpr double kViewTolerance_m = 2.5;

void look_around(const scene::Scene& recipes, const SceneRequest& request, PreviewScene& scene) {
  scene.around = surroundings_of(recipes);
  if (request.fog_share) scene.fog = fog_of(recipes, *request.fog_share);
}

// The level of a folder for views, if it is coarser than the one that is rendered.
std::optional<std::size_t> view_level_of(const LoadRequest& request) {
  std::error_code none;
  if (!std::filesystem::is_directory(request.paths.front(), none)) return std::nullopt;
  const Result<verify::RunRecord> record = verify::read_report(request.paths.front());
  if (!record) return std::nullopt;
  const auto fits = std::ranges::find_if(record->tiles, [](const verify::WrittenTile& tile) {
    return std::abs(tile.tolerance_m - kViewTolerance_m) < 0.01 * kViewTolerance_m;
  });
  return fits != record->tiles.end() && fits->level != request.level ? std::optional(fits->level) : std::nullopt;
}

Result<std::vector<bake::BakedTile>> view_tiles_of(const LoadRequest& request) {
  const OnProgress quiet = [](auto&&...) {};
  if (request.paths.front().ends_with(".kiln")) {
    const Result<scene::Scene> scene = read_scene(request);
    if (!scene) return scene.error();
    return coarse_tiles(*scene, request.threads);
  }
  LoadRequest coarse = request;
  const std::optional<std::size_t> level = view_level_of(request);
  if (!level) return std::vector<bake::BakedTile>();
  coarse.level = *level;
  Result<Loaded> loaded = load_tiles(coarse, quiet);
  if (!loaded) return loaded.error();
  return std::move(loaded->tiles);
}

}  // namespace

std::optional<double> PreviewScene::ground_height_m(Vec2 place) const {
  return recipes ? commands::ground_height_m(*recipes, place) : commands::ground_height_m(loaded.tiles, place);
}

Result<PreviewScene> load_preview_scene(const SceneRequest& request, const OnProgress& on_progress) {
  const bool is_manifest = request.load.paths.size() == 1 && request.load.paths.front().ends_with(".kiln");
  if (request.fog_share && !is_manifest)
    return Error{"--fog", "needs a manifest (scene.kiln), which knows the valleys"};
  PreviewScene scene;
  if (asks_for_cells(request.load) && !request.needs_tiles) {
    Result<scene::Scene> recipes = read_scene(request.load);
    if (!recipes) return recipes.error();
    scene.loaded.header = recipes->header, scene.sky = recipes->header.sky;
    look_around(*recipes, request, scene);
    if (sky::is_night(scene.sky)) scene.lamps = preview::lamps_of(*recipes, request.load.threads);
    scene.recipes = std::move(*recipes);
  } else {
    Result<Loaded> loaded = load_tiles(request.load, on_progress);
    if (!loaded) return loaded.error();
    const Result<sky::Sky> sky = sky_of(request.load, loaded->header);
    if (!sky) return sky.error();
    scene.loaded = std::move(*loaded), scene.sky = *sky;
    if (sky::is_night(scene.sky)) scene.lamps = preview::lamps_of(scene.loaded.tiles);
    if (is_manifest) {
      const Result<scene::Scene> recipes = read_scene(request.load);
      if (!recipes) return recipes.error();
      look_around(*recipes, request, scene);
    }
  }
  if (!request.finds_views) return scene;
  on_progress("find a view", 0);
  Result<std::vector<bake::BakedTile>> tiles = view_tiles_of(request.load);
  if (!tiles) return tiles.error();
  scene.for_views = std::move(*tiles);
  return scene;
}

preview::World world_of(const PreviewScene& scene, const preview::Camera& camera, int height_px,
                        const CellRequest& cells) {
  if (!scene.recipes) return preview::World(scene.loaded.tiles, camera.eye);
  return preview::World(cells_for(*scene.recipes, camera, height_px, cells.pixel_error), camera.eye,
                        cells.budget_bytes > 0 ? cells.budget_bytes : default_budget_bytes());
}

}  // namespace citykiln::commands
