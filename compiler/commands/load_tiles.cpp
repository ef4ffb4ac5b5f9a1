#include "compiler/commands/load_tiles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <filesystem>

#include "compiler/commands/requested_sky.h"
#include "compiler/commands/run_paths.h"
#include "compiler/pipeline.h"
#include "compiler/verify/run_report.h"
#include "exporters/gltf/glb.h"
#include "exporters/kiln/manifest.h"

namespace citykiln::commands {
namespace {

namespace fs = std::filesystem;

Result<Loaded> bake_manifest(const LoadRequest& request, const OnProgress& on_progress) {
  const Result<std::string> path = manifest_of(request.paths.front());
  if (!path) return path.error();
  Result<scene::Scene> scene = exporters::read_manifest(*path, request.only);
  if (!scene) return scene.error();
  Result<sky::Sky> sky = sky_of(request, scene->header);
  if (!sky) return sky.error();
  scene->header.sky = std::move(*sky);
  Loaded loaded;
  loaded.header = scene->header;
  Report report;
  const std::vector<double> ladder_m = {request.tolerance_m.value_or(0.1)};
  const Result<Done> baked = bake_scene(*scene, ladder_m, request.threads, report, on_progress,
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

Result<Loaded> read_files(const std::vector<std::string>& paths, const fs::path& manifest_path,
                          const OnProgress& on_progress) {
  Loaded loaded;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    on_progress("read tiles", static_cast<double>(i) / static_cast<double>(paths.size()));
    Result<bake::BakedTile> tile = exporters::read_glb(paths[i]);
    if (!tile) return tile.error();
    loaded.tiles.push_back(std::move(*tile));
  }
  std::ranges::stable_sort(loaded.tiles, {}, &bake::BakedTile::tile);
  Result<std::optional<scene::Header>> header = header_beside(manifest_path, loaded.tiles.front().tile);
  if (!header) return header.error();
  loaded.header = std::move(*header);
  return loaded;
}

Result<Loaded> read_folder(const LoadRequest& request, const OnProgress& on_progress) {
  const std::string& folder = request.paths.front();
  const Result<verify::RunRecord> record = verify::read_report(folder);
  if (!record) return record.error();
  std::vector<std::string> paths;
  for (const verify::WrittenTile& tile : record->tiles) {
    const bool is_asked_for = request.only.empty() || std::ranges::binary_search(request.only, tile.tile);
    if (tile.level == request.level && is_asked_for) paths.push_back(folder + "/" + tile.file.name);
  }
  if (paths.empty()) return Error{folder, fmt::format("has none of the requested tiles at level {}", request.level)};
  return read_files(paths, fs::path(folder) / "scene.kiln", on_progress);
}

}  // namespace

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
  if (is_folder) return read_folder(request, on_progress);
  // the manifest of OUT/glb/0_0_L0.glb is OUT/scene.kiln
  return read_files(request.paths, fs::path(first).parent_path() / ".." / "scene.kiln", on_progress);
}

}  // namespace citykiln::commands
