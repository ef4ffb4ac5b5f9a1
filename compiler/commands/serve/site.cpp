#include "compiler/commands/serve/site.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>
#include <utility>

#include "compiler/commands/run_paths.h"
#include "compiler/outputs/bake_keys.h"
#include "compiler/outputs/run_report.h"
#include "compiler/outputs/write_page.h"
#include "compiler/outputs/write_tiles3d.h"
#include "exporters/content_hash.h"
#include "exporters/file.h"
#include "exporters/kiln/manifest.h"
#include "exporters/run_files.h"

namespace citykiln::commands {
namespace {

constexpr std::array<std::pair<std::string_view, const char*>, 9> kTypes = {
    {{".html", "text/html; charset=utf-8"},
     {".js", "application/javascript; charset=utf-8"},
     {".css", "text/css; charset=utf-8"},
     {".json", "application/json; charset=utf-8"},
     {".txt", "text/plain; charset=utf-8"},
     {".wasm", "application/wasm"},
     {".glb", "model/gltf-binary"},
     {".png", "image/png"},
     {".jpg", "image/jpeg"}}};

const std::string kTreeFolder = std::string(exporters::kTilesetFolder) + "/";
const std::string kPageFiles = std::string(exporters::kPageFolder) + "/";
constexpr std::string_view kNoFindings = R"({"type": "FeatureCollection", "features": []})";

std::vector<std::byte> bytes_of(std::string_view text) {
  const auto* first = reinterpret_cast<const std::byte*>(text.data());
  return {first, first + text.size()};
}

bool depends_on_shown(const std::string& name) { return name.starts_with(kTreeFolder) || name.starts_with(kPageFiles); }

/// The settings of a run that matter for its tileset.
void take_settings(const outputs::RunRecord& record, Outputs& outputs) {
  if (!outputs.compress) outputs.compress = record.compress;
  std::set<double> levels_m;
  for (const outputs::WrittenTile& tile : record.tiles.empty() ? record.usd : record.tiles)
    levels_m.insert(tile.tolerance_m);
  if (!levels_m.empty()) outputs.tolerances_m.assign(levels_m.begin(), levels_m.end());
}

std::string text_of(const Outputs& outputs) {
  return fmt::format("levels {} lights {} compress {} split {} geoid {} surroundings {}",
                     fmt::join(outputs.tolerances_m, ","), outputs.lights,
                     name_of(compression_of(outputs, Target::kCesium)), name_of(outputs.split),
                     outputs.geoid ? outputs.geoid->name : "", outputs.surroundings != AroundWish::kNo);
}

std::string text_of(const scene::Shown& shown) {
  return fmt::format("left out {} woods {} lamps {} lit {}", shown.left_out, shown.wood_density,
                     static_cast<int>(shown.lamps), shown.lit_windows.value_or(-1));
}

}  // namespace

Site::Site(const SiteRequest& request)
    : outputs_(request.outputs),
      shown_(request.shown),
      has_page_(request.has_page),
      cache_(request.cache_bytes, std::max(1, request.threads == 0 ? 2 : request.threads)) {}

Result<std::unique_ptr<Site>> Site::open(const SiteRequest& request) {
  std::unique_ptr<Site> site(new Site(request));
  std::error_code none;
  if (!std::filesystem::is_directory(request.path, none)) {
    if (const Result<Done> done = site->add_scene(request, request.path, false); !done) return done.error();
    return site;
  }
  const auto list = exporters::read_file_list(request.path + "/" + exporters::kFileListName);
  if (!list) return list.error();
  if (!*list) return Error{request.path, "holds no finished run; expected the folder that compile wrote, or a .kiln"};
  if (const Result<Done> done = site->add_run(request, **list); !done) return done.error();
  return site;
}

Result<Done> Site::add_run(const SiteRequest& request, const exporters::FileList& list) {
  const bool shows_own = shown_ == scene::ShownRequest{};
  for (const exporters::ListedFile& file : list) {
    if (!shows_own && depends_on_shown(file.name)) continue;
    entries_[file.name] = {.file = request.path + "/" + file.name,
                           .etag = file.hash.empty() ? "" : fmt::format("\"{}\"", file.hash)};
  }
  entries_[exporters::kFileListName] = {.file = request.path + "/" + exporters::kFileListName};
  const bool has_tileset = shows_own && exporters::has_file(list, kTreeFolder + exporters::kTilesetName);
  const bool has_all = has_tileset && (!has_page_ || exporters::has_file(list, exporters::kPageName));
  if (has_all) return Done{};
  if (!exporters::has_file(list, exporters::kManifestName)) return missing_manifest(request.path);
  const Result<outputs::RunRecord> record = outputs::read_report(request.path);
  if (!record) return record.error();
  take_settings(*record, outputs_);
  return add_scene(request, request.path + "/" + exporters::kManifestName, has_tileset);
}

Result<Done> Site::add_scene(const SiteRequest& request, const std::string& manifest, bool has_tileset) {
  const Result<std::vector<std::byte>> bytes = exporters::read_file(manifest);
  if (!bytes) return bytes.error();
  Result<scene::Scene> scene = exporters::read_manifest(manifest, {});
  if (!scene) return scene.error();
  scene_ = std::move(*scene);
  scene_.header.shown = scene::with_request(scene_.header.shown, shown_);
  Result<map::Geoid> geoid = outputs::geoid_of(scene_.header, outputs_);
  if (!geoid) return geoid.error();
  geoid_ = std::move(*geoid);
  std::uint64_t textures = 0;
  if (!has_tileset) {
    Result<std::unique_ptr<outputs::TreeSource>> tree = outputs::TreeSource::open(scene_, outputs_, request.threads);
    if (!tree) return Error{manifest, tree.error().message};
    tree_ = std::move(*tree);
    textures = tree_->textures_hash();
  }
  version_ = exporters::content_hash(*bytes) ^ outputs::program_hash() ^
             exporters::content_hash(text_of(outputs_) + text_of(scene_.header.shown)) ^ textures;
  if (has_page_) add_page();
  return Done{};
}

void Site::add_page() {
  for (outputs::PageContent& file : outputs::page_contents(scene_, outputs_, geoid_))
    if (!entries_.contains(file.name))
      entries_[file.name] = made(file.name, [make = std::move(file.make)] { return bytes_of(make()); });
  if (!entries_.contains(exporters::kFindingsName))
    entries_[exporters::kFindingsName] = made(exporters::kFindingsName, [] { return bytes_of(kNoFindings); });
}

Site::Entry Site::made(std::string_view name, ContentCache::Make make) const {
  const std::uint64_t hash = version_ ^ exporters::content_hash(name);
  return {.make = std::move(make), .etag = fmt::format("\"{}\"", exporters::hash_text(hash))};
}

std::optional<Site::Entry> Site::entry_at(const std::string& name) const {
  const auto found = entries_.find(name);
  if (found != entries_.end()) return found->second;
  if (!tree_ || !name.starts_with(kTreeFolder)) return std::nullopt;
  const std::string content = name.substr(kTreeFolder.size());
  if (tree_->has(content)) return made(name, [this, content] { return tree_->make(content); });
  const auto document = tree_->documents().find(name);
  if (document == tree_->documents().end()) return std::nullopt;
  return made(name, [&text = document->second] { return bytes_of(text); });
}

HttpAnswer Site::answer(const HttpRequest& request) const {
  if (request.path.find("..") != std::string::npos) return {.status = 403};
  if (!request.path.starts_with('/')) return {.status = 404};
  const std::string name = request.path == "/" ? exporters::kPageIndexName : request.path.substr(1);
  std::optional<Entry> entry = entry_at(name);
  if (!entry) return {.status = 404};
  if (!entry->etag.empty() && request.etag == entry->etag) return {.status = 304, .etag = entry->etag};
  HttpAnswer answer{.status = 200, .type = media_type_of(name), .etag = entry->etag, .file = entry->file};
  if (entry->make)
    answer.make = [this, name, make = std::move(entry->make)](const IsWanted& is_wanted) {
      return cache_.get(name, is_wanted, make);
    };
  return answer;
}

void Site::prepare() const {
  if (!tree_) return;
  tree_->documents();
  if (!has_page_) return;
  const std::string content = tree_->first_content();
  cache_.get(
      kTreeFolder + content, [] { return true; }, [&] { return tree_->make(content); });
}

const char* media_type_of(std::string_view name) {
  const auto found = std::ranges::find_if(kTypes, [&](const auto& type) { return name.ends_with(type.first); });
  return found == kTypes.end() ? "application/octet-stream" : found->second;
}

bool is_own_host(std::string_view host, int port) {
  return host == fmt::format("127.0.0.1:{}", port) || host == fmt::format("localhost:{}", port);
}

}  // namespace citykiln::commands
