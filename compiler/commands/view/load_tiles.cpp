#include "compiler/commands/view/load_tiles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <optional>

#include "compiler/bake/far/bake_surroundings.h"
#include "compiler/bake/far/bend.h"
#include "compiler/bake_scene.h"
#include "compiler/commands/run_paths.h"
#include "compiler/commands/view/read_tileset_tree.h"
#include "compiler/commands/view/requested_sky.h"
#include "compiler/contract/system/for_each_slot.h"
#include "compiler/outputs/run_report.h"
#include "exporters/gltf/glb.h"
#include "exporters/kiln/manifest.h"
#include "exporters/run_files.h"

namespace citykiln::commands {
namespace {

namespace fs = std::filesystem;

/// Moves a tile from the inside of a cylinder to the plane, in which views are chosen, and remembers the cylinder.
void flatten(bake::BakedTile& tile, std::optional<map::Cylinder>& cylinder) {
  if (!tile.cylinder) return;
  cylinder = map::Cylinder{tile.cylinder->radius_m};
  tile = bake::flattened(std::move(tile));
}

Result<Loaded> bake_manifest(const LoadRequest& request, const OnProgress& on_progress) {
  const Result<std::string> path = find_committed_manifest(request.paths.front());
  if (!path) return path.error();
  Result<scene::Scene> scene = exporters::read_manifest(*path, request.only);
  if (!scene) return scene.error();
  scene->header.sky = sky_of(request, scene->header);
  scene->header.shown = scene::with_request(scene->header.shown, request.shown);
  Loaded loaded;
  loaded.header = scene->header, loaded.manifest_path = *path;
  loaded.cylinder = scene::cylinder_of(scene->header);
  Report report;
  const std::vector<double> tolerances_m = {request.tolerance_m.value_or(0.1)};
  const Result<Done> baked = bake_scene(*scene, tolerances_m, request.threads, report, on_progress,
                                        [&](const bake::BakedTile& tile, std::size_t) -> Result<Done> {
                                          loaded.tiles.push_back(tile);
                                          return Done{};
                                        });
  if (!baked) return baked.error();
  return loaded;
}

/// The header of the manifest at this path, if there is one.
Result<std::optional<scene::Header>> header_beside(const fs::path& manifest_path, scene::TileKey tile) {
  std::error_code none;
  if (!fs::exists(manifest_path, none)) return std::optional<scene::Header>();
  // reads a single chunk, since only the header is needed
  const Result<scene::Scene> scene = exporters::read_manifest(manifest_path.string(), std::vector{tile});
  if (!scene) return scene.error();
  return std::optional(scene->header);
}

// Reads files in parallel. The error is that of the first file that cannot be read.
Result<std::vector<bake::BakedTile>> read_all(const std::vector<std::string>& paths, const OnProgress& on_progress) {
  std::vector<std::optional<Result<bake::BakedTile>>> read(paths.size());
  std::vector<bake::BakedTile> tiles;
  for_each_in_order(
      paths.size(), 0, [&](std::size_t i) { read[i] = exporters::read_glb(paths[i]); },
      [&](std::size_t i) {
        on_progress("read tiles", static_cast<double>(i) / static_cast<double>(paths.size()));
        if (*read[i]) tiles.push_back(std::move(**read[i]));
        return tiles.size() > i;
      });
  if (tiles.size() < paths.size()) return read[tiles.size()]->error();
  return tiles;
}

bool is_backdrop(const bake::BakedTile& tile) { return tile.tile == bake::kSurroundingsTile; }

// Moves the land around out of the tiles, or reads it from the file beside them.
Result<Done> find_backdrop(const fs::path& folder, Loaded& loaded) {
  const auto given = std::ranges::find_if(loaded.tiles, is_backdrop);
  if (given != loaded.tiles.end()) {
    loaded.backdrop = std::move(*given), loaded.tiles.erase(given);
    return Done{};
  }
  const fs::path beside = folder / exporters::kSurroundingsContent;
  std::error_code none;
  if (!fs::exists(beside, none)) return Done{};
  Result<bake::BakedTile> tile = exporters::read_glb(beside.string());
  if (!tile) return tile.error();
  loaded.backdrop = std::move(*tile);
  return Done{};
}

Result<Loaded> read_files(const std::vector<std::string>& paths, const fs::path& manifest_path,
                          const OnProgress& on_progress) {
  Loaded loaded;
  Result<std::vector<bake::BakedTile>> tiles = read_all(paths, on_progress);
  if (!tiles) return tiles.error();
  loaded.tiles = std::move(*tiles);
  const Result<Done> around = find_backdrop(fs::path(paths.front()).parent_path(), loaded);
  if (!around) return around.error();
  for (bake::BakedTile& tile : loaded.tiles) flatten(tile, loaded.cylinder);
  if (loaded.tiles.empty()) return Error{paths.front(), "is the land around a scene; give its tiles too"};
  std::ranges::stable_sort(loaded.tiles, {}, &bake::BakedTile::tile);
  Result<std::optional<scene::Header>> header = header_beside(manifest_path, loaded.tiles.front().tile);
  if (!header) return header.error();
  loaded.header = std::move(*header);
  if (loaded.header) loaded.manifest_path = manifest_path.string();
  return loaded;
}

/// Says what a folder has instead of the requested tiles of a level.
std::string without_tiles(const outputs::RunRecord& record, std::size_t level) {
  std::map<std::size_t, double> tolerances_m;
  for (const outputs::WrittenTile& tile : record.tiles) tolerances_m[tile.level] = tile.tolerance_m;
  if (tolerances_m.empty()) return "has no tiles as .glb; compile or bake with --emit glb, or give its scene.kiln";
  if (tolerances_m.contains(level)) return fmt::format("has none of the requested tiles at level {}", level);
  std::string levels;
  for (const auto& [number, tolerance_m] : tolerances_m)
    levels += fmt::format("{}{} ({} m)", levels.empty() ? "" : ", ", number, tolerance_m);
  return fmt::format("has no level {}; its levels are {}", level, levels);
}

Result<Loaded> read_folder(const LoadRequest& request, const OnProgress& on_progress) {
  const std::string& folder = request.paths.front();
  const Result<outputs::RunRecord> record = outputs::read_report(folder);
  if (!record) return record.error();
  std::vector<std::string> paths;
  const std::size_t level = request.level.value_or(0);
  for (const outputs::WrittenTile& tile : record->tiles) {
    const bool is_asked_for = request.only.empty() || std::ranges::binary_search(request.only, tile.tile);
    if (tile.level == level && is_asked_for) paths.push_back(folder + "/" + tile.file.name);
  }
  if (paths.empty()) return Error{folder, without_tiles(*record, level)};
  return read_files(paths, fs::path(folder) / exporters::kManifestName, on_progress);
}

double from_coarse(double error_m) { return std::abs(std::log(std::max(error_m, 1e-6) / kCoarseTile_m)); }

// The levels of one tile, of which a coarse level has been read, as a chain from the coarsest to the finest.
TileNode chain_of(const std::vector<const outputs::WrittenTile*>& coarsest_first, const std::string& folder,
                  const exporters::OrientedBox& box) {
  TileNode chain;
  for (auto i = coarsest_first.rbegin(); i != coarsest_first.rend(); ++i) {
    const outputs::WrittenTile& level = **i;
    // inside of a cylinder the error may be larger than the tolerance
    TileNode node{
        .box = box, .error_m = std::max(level.tolerance_m, level.error_m), .path = folder + "/" + level.file.name};
    if (!chain.path.empty()) node.children.push_back(std::move(chain));
    chain = std::move(node);
  }
  return chain;
}

// Adds a tile of a run to the tree, by its levels.
Result<Done> add_tile(std::vector<const outputs::WrittenTile*> levels, const std::string& folder, TileTree& tree) {
  std::ranges::stable_sort(levels, std::ranges::greater{}, &outputs::WrittenTile::tolerance_m);
  const outputs::WrittenTile& coarse =
      **std::ranges::min_element(levels, {}, [](const auto* level) { return from_coarse(level->tolerance_m); });
  const std::string path = folder + "/" + coarse.file.name;
  Result<bake::BakedTile> tile = exporters::read_glb(path);
  if (!tile) return tile.error();
  exporters::OrientedBox box = exporters::box_of(*tile, {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}});
  if (!box.is_empty()) box.round_outwards(coarse.tolerance_m);
  tree.root.box.grow(box);
  tree.root.children.push_back(chain_of(levels, folder, box));
  flatten(*tile, tree.cylinder);
  tree.coarse_paths.push_back(path), tree.coarse.push_back(std::move(*tile));
  return Done{};
}

Result<TileTree> tree_of_run(const LoadRequest& request, const outputs::RunRecord& record,
                             const OnProgress& on_progress) {
  const std::string& folder = request.paths.front();
  std::map<scene::TileKey, std::vector<const outputs::WrittenTile*>> levels;
  for (const outputs::WrittenTile& tile : record.tiles)
    if (request.only.empty() || std::ranges::binary_search(request.only, tile.tile)) levels[tile.tile].push_back(&tile);
  if (levels.empty()) return Error{folder, "has none of the requested tiles"};
  TileTree tree{.root = {.error_m = std::numeric_limits<double>::infinity()},
                .manifest_path = folder + "/" + exporters::kManifestName};
  for (const auto& [key, of_tile] : levels) {
    on_progress("read coarse tiles", static_cast<double>(tree.coarse.size()) / static_cast<double>(levels.size()));
    if (const Result<Done> added = add_tile(of_tile, folder, tree); !added) return added.error();
  }
  return tree;
}

// Removes the land around, in which views are not chosen.
void leave_out_backdrop(TileTree& tree) {
  const auto found = std::ranges::find_if(tree.coarse, is_backdrop);
  if (found == tree.coarse.end()) return;
  tree.coarse_paths.erase(tree.coarse_paths.begin() + (found - tree.coarse.begin()));
  tree.coarse.erase(found);
}

Result<TileTree> tree_of_tileset(const LoadRequest& request, const std::string& folder, const OnProgress& on_progress) {
  if (!request.only.empty()) return Error{"--only", "cannot be used with 3D Tiles, whose inner tiles join several"};
  Result<TileNode> root = read_tileset_tree(folder);
  if (!root) return root.error();
  TileTree tree{
      .root = std::move(*root), .manifest_path = folder + "/../" + exporters::kManifestName, .is_on_ellipsoid = true};
  tree.coarse_paths = contents_of(tree.root, [](const TileNode& node) { return node.error_m <= kCoarseTile_m; });
  if (tree.coarse_paths.empty()) return Error{folder, "has a tileset without contents"};
  Result<std::vector<bake::BakedTile>> coarse = read_all(tree.coarse_paths, on_progress);
  if (!coarse) return coarse.error();
  tree.coarse = std::move(*coarse);
  for (bake::BakedTile& tile : tree.coarse) flatten(tile, tree.cylinder);
  tree.is_on_ellipsoid = !tree.cylinder;
  leave_out_backdrop(tree);
  return tree;
}

bool has_tileset(const fs::path& folder) {
  std::error_code none;
  return fs::exists(folder / exporters::kTilesetName, none);
}

}  // namespace

std::optional<scene::Header> header_of(const std::string& manifest_path, std::span<const bake::BakedTile> tiles) {
  std::error_code none;
  if (!fs::exists(manifest_path, none)) return std::nullopt;
  for (const bake::BakedTile& tile : tiles)
    if (const auto header = header_beside(manifest_path, tile.tile); header && *header) return **header;
  return std::nullopt;
}

std::string manifest_without_tiles(const std::string& path) {
  const std::string manifest = (fs::path(path) / exporters::kManifestName).string();
  std::error_code none;
  if (!fs::is_directory(path, none) || !fs::exists(manifest, none)) return path;
  if (has_tileset(path) || has_tileset(fs::path(path) / exporters::kTilesetFolder)) return path;
  const Result<outputs::RunRecord> record = outputs::read_report(path);
  return record && record->tiles.empty() ? manifest : path;
}

bool asks_for_levels(const LoadRequest& request) {
  std::error_code none;
  return !request.level && request.paths.size() == 1 && fs::is_directory(request.paths.front(), none);
}

Result<TileTree> read_tile_tree(const LoadRequest& request, const OnProgress& on_progress) {
  const std::string& folder = request.paths.front();
  if (has_tileset(folder)) return tree_of_tileset(request, folder, on_progress);
  const Result<outputs::RunRecord> record = outputs::read_report(folder);
  if (record && !record->tiles.empty()) return tree_of_run(request, *record, on_progress);
  const std::string tilesets = folder + "/" + exporters::kTilesetFolder;
  if (has_tileset(tilesets)) return tree_of_tileset(request, tilesets, on_progress);
  if (!record) return record.error();
  return Error{folder, "has no .glb tiles and no 3D Tiles; give its scene.kiln, or write tiles with --emit glb"};
}

Result<Loaded> load_contents(TileTree& tree, const std::vector<std::string>& paths, const OnProgress& on_progress) {
  Loaded loaded;
  loaded.cylinder = tree.cylinder;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    on_progress("read tiles", static_cast<double>(i) / static_cast<double>(paths.size()));
    const auto known =
        static_cast<std::size_t>(std::ranges::find(tree.coarse_paths, paths[i]) - tree.coarse_paths.begin());
    if (known < tree.coarse.size()) {
      loaded.tiles.push_back(std::move(tree.coarse[known]));
      continue;
    }
    Result<bake::BakedTile> tile = exporters::read_glb(paths[i]);
    if (!tile) return tile.error();
    flatten(*tile, loaded.cylinder);
    loaded.tiles.push_back(std::move(*tile));
  }
  tree.coarse_paths.clear(), tree.coarse.clear();
  if (!tree.is_on_ellipsoid && !paths.empty())
    if (const Result<Done> done = find_backdrop(fs::path(paths.front()).parent_path(), loaded); !done)
      return done.error();
  loaded.header = header_of(tree.manifest_path, loaded.tiles);
  return loaded;
}

Result<Loaded> load_tiles(const LoadRequest& request, const OnProgress& on_progress) {
  assert(request.tolerance_m.value_or(1) > 0 && std::ranges::is_sorted(request.only));
  if (request.paths.empty())
    return Error{"", "no input is given; expected a manifest, a folder of a run, or .glb files"};
  const std::string& first = request.paths.front();
  std::error_code none;
  const bool is_manifest = first.ends_with(".kiln"), is_folder = fs::is_directory(first, none);
  if ((is_manifest || is_folder) && request.paths.size() > 1)
    return Error{first, "cannot be combined with other inputs; give one manifest, one folder, or .glb files"};
  if (is_manifest) return bake_manifest(request, on_progress);
  if (is_folder && has_tileset(first))
    return Error{"--level", "is for .glb tiles; of 3D Tiles --pixel-error chooses the levels"};
  if (is_folder) return read_folder(request, on_progress);
  // the manifest of OUT/glb/0_0_L0.glb is OUT/scene.kiln
  return read_files(request.paths, fs::path(first).parent_path() / ".." / exporters::kManifestName, on_progress);
}

}  // namespace citykiln::commands
