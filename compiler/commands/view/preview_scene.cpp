#include "compiler/commands/view/preview_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <filesystem>

#include "compiler/bake/far/bake_surroundings.h"
#include "compiler/bake/far/bend.h"
#include "compiler/bake_scene.h"
#include "compiler/commands/view/ground_height.h"
#include "compiler/commands/view/hidden_by_land.h"
#include "compiler/commands/view/requested_sky.h"
#include "compiler/map/plane/heightfield.h"
#include "compiler/outputs/run_report.h"
#include "compiler/scene/ground_lookup.h"
#include "compiler/scene/scene.h"
#include "compiler/sky/inside/plan_inside.h"
#include "exporters/gltf/glb.h"
#include "exporters/kiln/manifest.h"

namespace citykiln::commands {
namespace {

// The ground beyond a scene, estimated from the land at its edge.

using preview::operator+, preview::operator*;
constexpr int kPlaces = 256, kDirections = 64;

// Values are means over this many directions on both sides.
constexpr int kBlur = kDirections / 8;

preview::Rgb albedo_of(map::LandCoverClass cover) {
  const auto& colour = values_of(map::values_of(cover).material).base_colour;
  return {colour[0], colour[1], colour[2]};
}

// Returns the means of the places around a direction.
preview::Edge edge_of(const std::vector<scene::GroundPlace>& samples, int direction) {
  using preview::operator+, preview::operator*;
  preview::Edge edge;
  constexpr int kEach = kPlaces / kDirections, kReach = kBlur * kEach;
  double land = 0;
  for (int i = -kReach; i <= kReach; ++i) {
    const scene::GroundPlace& sample = samples[static_cast<std::size_t>(direction * kEach + i + kPlaces) % kPlaces];
    const bool is_sea = sample.cover == map::LandCoverClass::kSea;
    edge.height_m += (is_sea ? 0 : sample.height_m) / (2 * kReach + 1);
    if (is_sea)
      edge.sea += 1.0 / (2 * kReach + 1);
    else
      edge.albedo = edge.albedo + albedo_of(sample.cover), ++land;
  }
  if (land > 0) edge.albedo = edge.albedo * (1 / land);
  return edge;
}

// Replaces heights and sea of the samples by those at the end of the grid.
void stand_on(const surroundings::Surroundings& grid, std::vector<scene::GroundPlace>& samples) {
  const std::vector<Vec2> places = scene::places_on_border(grid.box(), kPlaces);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].height_m = surroundings::height_m_at(grid, places[i]);
    const bool is_sea = is_open_water(surroundings::cover_at(grid, places[i]));
    if (is_sea)
      samples[i].cover = map::LandCoverClass::kSea;
    else if (samples[i].cover == map::LandCoverClass::kSea)
      samples[i].cover = map::LandCoverClass::kUnknown;
  }
}

std::vector<scene::GroundPlace> samples_on_border(const scene::GroundLookup& lookup) {
  std::vector<scene::GroundPlace> samples;
  for (const Vec2 place : scene::places_on_border(lookup.box(), kPlaces)) samples.push_back(lookup.at(place));
  return samples;
}

preview::Surroundings beyond(const Box2& box, const std::vector<scene::GroundPlace>& samples) {
  preview::Surroundings around{.box = box, .ring = {}};
  for (int i = 0; i < kDirections; ++i) around.ring.push_back(edge_of(samples, i));
  around.mean = preview::mean_of(around.ring);
  return around;
}

// Returns the ground that continues the edge of the chunks, even if the header has a grid around them.
preview::Surroundings plain_around(const scene::Scene& scene) {
  assert(!scene.chunks.empty());
  const scene::GroundLookup lookup(scene);
  return beyond(lookup.box(), samples_on_border(lookup));
}

// Returns the ground that continues the land and sea at the scene's edge to the horizon. The edge is that of the
// chunks, or of the grid of heights around them (scene::Header::around).
//
// Method: 256 places along the edge have the height of the terrain, 0 at sea, and the colour of the topmost land cover
// polygon. In each of 64 directions height, colour and share of sea are means over an eighth of the circle on both
// sides. Cost: O(polygons of the chunks at the edge).
preview::Surroundings surroundings_of(const scene::Scene& scene) {
  const surroundings::Surroundings& grid = scene.header.around;
  if (grid.is_empty()) return plain_around(scene);
  assert(!scene.chunks.empty());
  std::vector<scene::GroundPlace> samples = samples_on_border(scene::GroundLookup(scene));
  stand_on(grid, samples);
  return beyond(grid.box(), samples);
}

// Returns fog that reaches up to a height.
// @param share  Share of the scene's terrain that lies below this height, 0 to 1.
preview::Fog fog_of(const scene::Scene& scene, double share) {
  assert(!scene.chunks.empty() && share >= 0 && share <= 1);
  std::vector<double> heights_m;
  for (const scene::Chunk& chunk : scene.chunks) {
    const Box2 box = scene::box_of(scene.header, chunk.tile);
    for (int j = 0; j < chunk.heights.rows; ++j)
      for (int i = 0; i < chunk.heights.columns; ++i)
        if (box.contains(chunk.heights.vertex(i, j))) heights_m.push_back(chunk.heights.height_m_at_vertex(i, j));
  }
  if (heights_m.empty()) return {.top_m = scene.chunks.front().heights.height_m_at_vertex(0, 0)};
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(heights_m.size() - 1));
  std::ranges::nth_element(heights_m, heights_m.begin() + rank);
  return {.top_m = heights_m[static_cast<std::size_t>(rank)]};
}

// The tolerance of the tiles from which views are found: coarse enough to be quick, fine enough for streets and walls.
constexpr double kViewTolerance_m = 2.5;

// The tolerance at which a manifest of a world inside of a cylinder is baked if none is given.
constexpr double kInsideTolerance_m = 0.5;

// Returns the part of the plane that the tiles cover if that is a box, else an empty box.
Box2 filled_box(const scene::Scene& recipes) {
  Box2 all;
  double area_m2 = 0;
  for (const scene::Chunk& chunk : recipes.chunks) {
    const Box2 box = scene::box_of(recipes.header, chunk.tile);
    all.grow(box.min), all.grow(box.max);
    area_m2 += box.width() * box.height();
  }
  return area_m2 == all.width() * all.height() ? all : Box2{};
}

void look_around(const scene::Scene& recipes, const SceneRequest& request, PreviewScene& scene) {
  scene.around = surroundings_of(recipes);
  if (!recipes.header.around.is_empty()) scene.plain = plain_around(recipes);
  scene.backdrop = bake::bake_surroundings(recipes);
  scene.clear = filled_box(recipes);
  if (request.fog_share) scene.fog = fog_of(recipes, *request.fog_share);
}

// Does so with the manifest of baked tiles, if there is one.
void look_around(const std::string& manifest_path, const std::vector<scene::TileKey>& only, const SceneRequest& request,
                 PreviewScene& scene) {
  scene.backdrop = std::move(scene.loaded.backdrop);
  if (manifest_path.empty()) return;
  const Result<scene::Scene> recipes = exporters::read_manifest(manifest_path, only);
  if (recipes && !recipes->chunks.empty()) look_around(*recipes, request, scene);
}

std::vector<scene::TileKey> keys_of(std::span<const bake::BakedTile> tiles) {
  std::vector<scene::TileKey> keys;
  for (const bake::BakedTile& tile : tiles) keys.push_back(tile.tile);
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  return keys;
}

// The level of a folder for views, if it is coarser than the one that is rendered.
std::optional<std::size_t> view_level_of(const LoadRequest& request) {
  std::error_code none;
  if (!std::filesystem::is_directory(request.paths.front(), none)) return std::nullopt;
  const Result<outputs::RunRecord> record = outputs::read_report(request.paths.front());
  if (!record) return std::nullopt;
  const auto fits = std::ranges::find_if(record->tiles, [](const outputs::WrittenTile& tile) {
    return std::abs(tile.tolerance_m - kViewTolerance_m) < 0.01 * kViewTolerance_m;
  });
  return fits != record->tiles.end() && fits->level != request.level.value_or(0) ? std::optional(fits->level)
                                                                                 : std::nullopt;
}

Result<std::vector<bake::BakedTile>> view_tiles_of(const LoadRequest& request) {
  const OnProgress quiet = [](auto&&...) {};
  if (request.paths.front().ends_with(".kiln")) {
    const Result<scene::Scene> scene = read_scene(request);
    if (!scene) return scene.error();
    return bake_tiles(*scene, kCoarseTile_m, request.threads);
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
  if (!tree)
    return recipes ? commands::ground_height_m(*recipes, place) : commands::ground_height_m(loaded.tiles, place);
  constexpr std::size_t kMostKept = 4;
  std::optional<double> highest;
  for (const std::string& path : finest_contents_at(tree->root, place)) {
    if (!ground_tiles_.contains(path)) {
      if (ground_tiles_.size() >= kMostKept) ground_tiles_.clear();
      Result<bake::BakedTile> tile = exporters::read_glb(path);
      if (!tile) continue;
      ground_tiles_.emplace(path, std::move(*tile));
    }
    const auto height_m = commands::ground_height_m(std::span(&ground_tiles_.at(path), 1), place);
    if (height_m) highest = std::max(highest.value_or(*height_m), *height_m);
  }
  return highest;
}

namespace {

// Sets the recipes that are rendered, with their sky, lamps and surroundings.
void take_recipes(scene::Scene recipes, const SceneRequest& request, PreviewScene& scene) {
  scene.loaded.header = recipes.header, scene.sky = recipes.header.sky;
  look_around(recipes, request, scene);
  if (are_lamps_lit(recipes.header.shown, scene.sky)) scene.lamps = preview::lamps_of(recipes, request.load.threads);
  scene.recipes = std::move(recipes);
}

// Leaves out the layers that are not asked for, and lights the lamps of tiles.
void take_tiles(const LoadRequest& load, PreviewScene& scene) {
  const scene::Shown shown = scene::with_request(scene.loaded.header.value_or(scene::Header{}).shown, load.shown);
  for (bake::BakedTile& tile : scene.loaded.tiles) {
    std::erase_if(tile.primitives, [&](const bake::Primitive& p) { return !is_shown(shown, p.layer); });
    std::erase_if(tile.instanced, [&](const bake::InstancedMesh& m) {
      return !m.primitives.empty() && !is_shown(shown, m.primitives.front().layer);
    });
  }
  if (are_lamps_lit(shown, scene.sky)) scene.lamps = preview::lamps_of(scene.loaded.tiles);
}

// Error: what tiles cannot show in another way than they were baked.
Result<Done> check_shown(const LoadRequest& load) {
  const bool is_manifest = load.paths.size() == 1 && load.paths.front().ends_with(".kiln");
  const bool leaves_yards = load.shown.left_out && has(*load.shown.left_out, scene::SceneLayer::kYards);
  const char* option = load.shown.wood_density  ? "--wood-density"
                       : load.shown.lit_windows ? "--lit-windows"
                       : leaves_yards           ? "--layers"
                                                : nullptr;
  if (is_manifest || option == nullptr) return Done{};
  return Error{option, fmt::format("{} decided when tiles are baked; give the manifest (scene.kiln) instead",
                                   leaves_yards ? "yards are" : "this is")};
}

// The number of leaves of a tree that are too coarse for the viewers.
std::size_t too_coarse(const TileNode& node, const Viewers& viewers) {
  if (node.children.empty()) return node.path.empty() || is_fine_for(viewers, node) ? 0 : 1;
  std::size_t count = 0;
  for (const TileNode& child : node.children) count += too_coarse(child, viewers);
  return count;
}

// Replaces a tree by the recipes of its manifest if some of its tiles are too coarse at their finest level. Returns
// false if they are fine, or if there are no recipes of the same frame.
bool take_recipes_where_coarse(const SceneRequest& request, const Viewers& viewers, PreviewScene& scene) {
  const TileTree& tree = *scene.tree;
  if (viewers.eyes.empty() || tree.is_on_ellipsoid || tree.cylinder || request.needs_tiles) return false;
  const std::size_t coarse = too_coarse(tree.root, viewers);
  std::error_code none;
  if (coarse == 0 || !std::filesystem::exists(tree.manifest_path, none)) return false;
  LoadRequest load = request.load;
  load.paths = {tree.manifest_path};
  Result<scene::Scene> recipes = read_scene(load);
  if (!recipes) return false;
  scene.note =
      fmt::format("recipes of {}: its tiles at {} of {} places are coarser than {} pixels; --level N shows tiles",
                  tree.manifest_path, coarse, scene.tree->coarse.size(), viewers.pixel_error);
  scene.tree.reset();
  take_recipes(std::move(*recipes), request, scene);
  return true;
}

}  // namespace

Result<PreviewScene> load_preview_scene(const SceneRequest& request, const OnProgress& on_progress) {
  const bool is_manifest = request.load.paths.size() == 1 && request.load.paths.front().ends_with(".kiln");
  if (request.fog_share && !is_manifest)
    return Error{"--fog", "needs a manifest (scene.kiln), which knows the valleys"};
  if (const Result<Done> fits = check_shown(request.load); !fits) return fits.error();
  PreviewScene scene;
  if (asks_for_levels(request.load)) {
    Result<TileTree> tree = read_tile_tree(request.load, on_progress);
    if (!tree) return tree.error();
    scene.loaded.header = header_of(tree->manifest_path, tree->coarse);
    scene.sky = sky_of(request.load, scene.loaded.header);
    scene.tree = std::move(*tree);
    return scene;
  }
  std::optional<scene::Scene> cells;
  LoadRequest load = request.load;
  if (asks_for_cells(request.load) && !request.needs_tiles) {
    Result<scene::Scene> recipes = read_scene(request.load);
    if (!recipes) return recipes.error();
    if (!scene::cylinder_of(recipes->header)) cells = std::move(*recipes);
    load.tolerance_m = kInsideTolerance_m;
    scene.note = fmt::format(
        "note: a world inside of a cylinder is baked before it is rendered, at {} m; --tolerance M "
        "decides",
        kInsideTolerance_m);
  }
  if (cells) {
    scene.note.clear();
    take_recipes(std::move(*cells), request, scene);
  } else {
    Result<Loaded> loaded = load_tiles(load, on_progress);
    if (!loaded) return loaded.error();
    scene.sky = sky_of(request.load, loaded->header), scene.loaded = std::move(*loaded);
    take_tiles(request.load, scene);
    look_around(scene.loaded.manifest_path, keys_of(scene.loaded.tiles), request, scene);
  }
  if (!request.finds_views) return scene;
  on_progress("find a view", 0);
  Result<std::vector<bake::BakedTile>> tiles = view_tiles_of(request.load);
  if (!tiles) return tiles.error();
  scene.for_views = std::move(*tiles);
  return scene;
}

Result<Done> load_levels(PreviewScene& scene, const SceneRequest& request, const Viewing& viewing,
                         const OnProgress& on_progress) {
  if (!scene.tree) return Done{};
  Viewers viewers = viewers_of(viewing, request.cells.pixel_error);
  if (scene.tree->cylinder)
    for (Vec3& eye : viewers.eyes) eye = map::at(*scene.tree->cylinder, eye).at;
  if (take_recipes_where_coarse(request, viewers, scene)) return Done{};
  const auto is_fine = [&](const TileNode& node) { return !viewers.eyes.empty() && is_fine_for(viewers, node); };
  Result<Loaded> loaded = load_contents(*scene.tree, contents_of(scene.tree->root, is_fine), on_progress);
  if (!loaded) return loaded.error();
  scene.sky = sky_of(request.load, loaded->header), scene.loaded = std::move(*loaded);
  look_around(scene.tree->manifest_path, request.load.only, request, scene);
  // land in the plane does not meet tiles on the ellipsoid
  if (scene.tree->is_on_ellipsoid) scene.backdrop.reset();
  scene.tree.reset();
  take_tiles(request.load, scene);
  return Done{};
}

void bend_tiles(PreviewScene& scene) {
  if (!scene.loaded.cylinder) return;
  const map::Cylinder cylinder = *scene.loaded.cylinder;
  Box2 extent;
  for (bake::BakedTile& tile : scene.loaded.tiles) {
    for (const bake::Primitive& p : tile.primitives)
      for (const bake::Float3& at : p.positions) extent.grow(in_plan(tile.origin + bake::widened(at)));
    scene.bent.push_back(bake::bent(std::move(tile), cylinder));
  }
  scene.loaded.tiles.clear();
  scene.backdrop.reset();
  for (preview::StreetLamp& lamp : scene.lamps) {
    const map::BentPoint there = map::at(cylinder, lamp.at);
    lamp.at = there.at, lamp.up = there.up;
  }
  // without a manifest
  if (!scene.sky.inside) scene.sky.inside = sky::plan_inside(cylinder, extent);
}

bool leave_out_hiding_land(PreviewScene& scene, std::span<const preview::Camera> cameras) {
  if (!scene.backdrop || !scene.plain || !scene.loaded.header) return false;
  const auto is_hidden = [&](const preview::Camera& camera) {
    return is_hidden_by_land(*scene.loaded.header, scene.plain->box, camera.eye, camera.look_at);
  };
  if (std::ranges::none_of(cameras, is_hidden)) return false;
  scene.backdrop.reset(), scene.around = std::move(scene.plain);
  return true;
}

std::string levels_text(std::span<const bake::BakedTile> tiles) {
  std::map<double, std::size_t> counts;
  for (const bake::BakedTile& tile : tiles) ++counts[tile.tolerance_m];
  std::string text = "tiles:";
  for (const auto& [tolerance_m, count] : counts)
    text += fmt::format("{} {} at {} m", text.ends_with(':') ? "" : ",", count, tolerance_m);
  return text;
}

preview::World world_of(const PreviewScene& scene, const Viewing& viewing, const CellRequest& cells) {
  assert(!viewing.cameras.empty());
  const Vec3 eye = viewing.cameras.front().eye;
  const preview::Backdrop backdrop{scene.backdrop ? &*scene.backdrop : nullptr, scene.clear};
  if (scene.loaded.cylinder) return preview::World(scene.bent, eye);
  if (!scene.recipes) return preview::World(scene.loaded.tiles, eye, backdrop);
  return preview::World(cells_for(*scene.recipes, viewing, cells), eye, budget_bytes_of(cells), backdrop);
}

}  // namespace citykiln::commands
