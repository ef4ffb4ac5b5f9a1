#include "compiler/verify/check_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "compiler/contract/texts/parse.h"
#include "exporters/file_list.h"
#include "exporters/finish_commit.h"
#include "exporters/page/page_files.h"
#include "exporters/run_files.h"

namespace citykiln::verify {

using exporters::kFileListName, exporters::kFindingsName, exporters::kKeysName, exporters::kManifestName,
    exporters::kReportName, exporters::kTimingName;

namespace {

bool is_listed(const exporters::FileList& list, const std::string& name) {
  return std::ranges::find(list, name, &exporters::ListedFile::name) != list.end();
}

/// Returns the rest of a name after its folder; std::nullopt for names that are not in it.
std::optional<std::string_view> name_inside(std::string_view name, std::string_view folder) {
  if (!name.starts_with(folder) || !name.substr(folder.size()).starts_with('/')) return std::nullopt;
  return name.substr(folder.size() + 1);
}

/// True for the names of tiles, such as "3_-2_L0.glb".
bool is_name_of_tile(std::string_view name) {
  if (!name.ends_with(".glb")) return false;
  const std::string_view stem = name.substr(0, name.size() - 4);
  const std::size_t level = stem.rfind("_L");
  return level != std::string_view::npos && numbers_in<int>(stem.substr(0, level), '_', 2) &&
         number_in<int>(stem.substr(level + 2));
}

/// True for the names of files that tiles share, such as "shared/0123456789abcdef_64.bin".
bool is_name_of_shared(std::string_view name) {
  constexpr std::string_view kFolder = exporters::kSharedFolder, kHashDigits = "0123456789abcdef";
  if (!name.starts_with(kFolder)) return false;
  name.remove_prefix(kFolder.size());
  const std::size_t hash = name.find('_'), size = name.find('.');
  return hash == 16 && size != std::string_view::npos && size > hash && name.find_first_not_of(kHashDigits) == hash &&
         number_in<std::uint64_t>(name.substr(hash + 1, size - hash - 1));
}

/// True for names in glb/.
bool is_name_in_glb(std::string_view name) { return is_name_of_tile(name) || is_name_of_shared(name); }

/// True for the names of tiles, and for names such as "Q2_0_1.glb", "tileset.json" and "tileset_3.json".
bool is_name_in_tileset(std::string_view name) {
  if (name == exporters::kTilesetName || name == exporters::kSurroundingsContent || is_name_of_tile(name)) return true;
  if (name.starts_with("Q") && name.ends_with(".glb"))
    return numbers_in<int>(name.substr(1, name.size() - 5), '_', 3).has_value();
  return name.starts_with("tileset_") && name.ends_with(".json") &&
         number_in<int>(name.substr(8, name.size() - 13)).has_value();
}

void check_report(const outputs::RunRecord& record, const exporters::FileList& list, CheckResults& results) {
  for (const auto* levels : {&record.tiles, &record.usd})
    for (const outputs::WrittenTile& tile : *levels)
      results.files.test(is_listed(list, tile.file.name),
                         fmt::format("{} is in {}, but not in {}", tile.file.name, kReportName, kFileListName));
  if (record.has_manifest)
    results.files.test(is_listed(list, kManifestName), fmt::format("{} is not in {}", kManifestName, kFileListName));
}

/// True for names of the page in page/, such as "page/viewer.js" and "page/features/12.json".
bool is_page_name(const std::string& name) {
  if (name == exporters::kPageIndexName) return false;
  if (name == exporters::kPageName || name == exporters::kPageNamesName) return true;
  const std::vector<exporters::PageFile> files = exporters::page_files();
  if (std::ranges::find(files, name, &exporters::PageFile::name) != files.end()) return true;
  constexpr std::string_view kFolder = exporters::kPageFeatureFolder, kSuffix = ".json";
  if (!name.starts_with(kFolder) || !name.ends_with(kSuffix)) return false;
  const auto number = std::string_view(name).substr(kFolder.size(), name.size() - kFolder.size() - kSuffix.size());
  return number_in<std::uint64_t>(number).has_value();
}

bool is_usd_name(const std::string& name) {
  const auto is_in = [&](std::string_view folder, std::string_view suffix) {
    return name.starts_with(folder) && name.ends_with(suffix);
  };
  return name == exporters::kUsdSceneName || is_in(exporters::kUsdTileFolder, ".usda") ||
         is_in(exporters::kUsdTileFolder, ".usdc") || is_in(exporters::kUsdTextureFolder, ".png") ||
         is_in(exporters::kUsdTextureFolder, ".jpg");
}

}  // namespace

bool is_name_of_run(const std::string& name) {
  for (const char* own : {kManifestName, kReportName, kFindingsName, kTimingName, kKeysName, exporters::kGlbCloudsName,
                          exporters::kGlbSurroundingsName, exporters::kUsdSurroundingsName, exporters::kUsdCloudsName,
                          exporters::kVdbName, exporters::kTilesetArchiveName})
    if (name == own) return true;
  if (is_usd_name(name) || is_page_name(name)) return true;
  if (const auto inside = name_inside(name, exporters::kTilesetFolder)) return is_name_in_tileset(*inside);
  const auto inside = name_inside(name, exporters::kGlbFolder);
  return inside && is_name_in_glb(*inside);
}

Result<Done> check_folder(const LoadedRun& run, int threads, CheckResults& results) {
  const auto list = exporters::read_file_list(run.folder + "/" + kFileListName);
  if (!list) return list.error();
  results.files.test(list->has_value(), std::string(kFileListName) + " is missing");
  const exporters::FileList files = list->value_or(exporters::FileList());
  const exporters::FolderState state = exporters::compare_folder(run.folder, files, threads);
  results.files.tests += files.size() - state.missing.size() - state.changed.size();
  for (const std::string& name : state.missing) results.files.test(false, name + " is missing");
  for (const std::string& name : state.changed) results.files.test(false, name + " has another size or hash");
  check_report(run.record, files, results);
  results.stale.test(true, "");
  for (const std::string& name : state.unlisted) {
    if (is_name_of_run(name))
      results.stale.test(false, fmt::format("{} is not in {}", name, kFileListName));
    else
      results.unlisted.push_back(name);
  }
  results.has_unfinished_run = exporters::has_unfinished_run(run.folder);
  return Done{};
}

}  // namespace citykiln::verify
