#include "compiler/commands/load_rendered.h"

#include "compiler/commands/ground_height.h"
#include "compiler/sky/plan.h"

namespace citykiln::commands {
namespace {

/// The scene's sky, or the sky at another time; without a manifest at 45° north.
Result<sky::Sky> sky_of(const LoadRequest& request, const std::optional<scene::Header>& header) {
  if (header && request.time.empty()) return header->sky;
  return sky::plan(header ? header->origin : map::LonLat{0, 45}, request.time);
}

Result<Rendered> load_baked(const RenderedRequest& request, const Console& console) {
  Result<Loaded> loaded = load_tiles(request.load, console.progress());
  if (!loaded) return loaded.error();
  Result<sky::Sky> sky = sky_of(request.load, loaded->header);
  if (!sky) return sky.error();
  const GroundHeight ground_m = [&](Vec2 place) { return ground_height_m(loaded->tiles, place); };
  Result<std::vector<preview::Camera>> cameras = cameras_of(request.camera, *loaded, ground_m, console);
  if (!cameras) return cameras.error();
  Rendered rendered{.loaded = std::move(*loaded), .cameras = std::move(*cameras), .sky = std::move(*sky)};
  if (sky::is_night(rendered.sky)) rendered.lamps = preview::lamps_of(rendered.loaded.tiles);
  return rendered;
}

/// A view that was chosen on coarse ground: near the ground its height above that is kept.
preview::Camera on_ground(preview::Camera camera, std::span<const bake::BakedTile> coarse,
                          const GroundHeight& ground_m) {
  constexpr double kNear_m = 5;
  const std::optional<double> low_m = ground_height_m(coarse, in_plan(camera.eye));
  if (!low_m || camera.eye.z - *low_m > kNear_m) return camera;
  if (const std::optional<double> exact_m = ground_m(in_plan(camera.eye))) {
    camera.eye.z += *exact_m - *low_m, camera.look_at.z += *exact_m - *low_m;
  }
  return camera;
}

Result<Rendered> load_recipes(const RenderedRequest& request, const Console& console) {
  Result<scene::Scene> scene = read_scene(request.load);
  if (!scene) return scene.error();
  const GroundHeight ground_m = [&](Vec2 place) { return ground_height_m(*scene, place); };
  Loaded coarse{{}, scene->header};
  const bool is_named = !request.camera.eye && !request.camera.eye_lonlat && request.camera.path.empty();
  if (is_named) coarse.tiles = coarse_tiles(*scene, request.load.threads);
  Result<std::vector<preview::Camera>> cameras = cameras_of(request.camera, coarse, ground_m, console);
  if (!cameras) return cameras.error();
  if (is_named)
    for (preview::Camera& camera : *cameras) camera = on_ground(camera, coarse.tiles, ground_m);
  coarse.tiles = {};
  Rendered rendered{.loaded = std::move(coarse), .cameras = std::move(*cameras), .sky = scene->header.sky};
  if (sky::is_night(rendered.sky)) rendered.lamps = preview::lamps_of(*scene, request.load.threads);
  rendered.cells = cells_for(std::move(*scene), rendered.cameras.front(), request.height_px, request.cells.pixel_error);
  return rendered;
}

}  // namespace

Result<Rendered> load_rendered(const RenderedRequest& request, const Console& console) {
  return asks_for_cells(request.load) ? load_recipes(request, console) : load_baked(request, console);
}

preview::World world_of(const Rendered& rendered, const CellRequest& request) {
  const Vec3 eye = rendered.cameras.front().eye;
  if (!rendered.cells) return preview::World(rendered.loaded.tiles, eye);
  return preview::World(rendered.cells, eye, budget_bytes_of(request));
}

}  // namespace citykiln::commands
