#include "compiler/commands/view/complete_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "compiler/commands/interrupt_notice.h"
#include "compiler/commands/run_paths.h"
#include "compiler/outputs/run_report.h"
#include "compiler/outputs/texture_choice.h"
#include "compiler/outputs/write_page.h"
#include "compiler/outputs/write_tiles3d.h"
#include "exporters/file.h"
#include "exporters/finish_commit.h"
#include "exporters/kiln/manifest.h"
#include "exporters/output_folder.h"
#include "exporters/run_files.h"

namespace citykiln::commands {
namespace {

using OrderedJson = nlohmann::ordered_json;

const std::string kTileset = std::string(exporters::kTilesetFolder) + "/" + exporters::kTilesetName;

/// The settings of the run that matter for its tileset.
Outputs outputs_of(const PageRequest& request, const outputs::RunRecord& record) {
  Outputs outputs = request.outputs;
  outputs.folder = request.folder;
  if (!outputs.compress) outputs.compress = record.compress;
  outputs.tiles3d = true;
  // its ledger counts the objects that levels drop
  outputs.glb = true;
  std::set<double> levels_m;
  for (const outputs::WrittenTile& tile : record.tiles.empty() ? record.usd : record.tiles)
    levels_m.insert(tile.tolerance_m);
  if (!levels_m.empty()) outputs.tolerances_m.assign(levels_m.begin(), levels_m.end());
  return outputs;
}

/// report.json with the new files.
Result<std::string> report_with(const std::string& folder, const std::vector<outputs::WrittenFile>& files) {
  const std::string path = folder + "/" + exporters::kReportName;
  const Result<std::vector<std::byte>> bytes = exporters::read_file(path);
  if (!bytes) return bytes.error();
  OrderedJson report = OrderedJson::parse(reinterpret_cast<const char*>(bytes->data()),
                                          reinterpret_cast<const char*>(bytes->data()) + bytes->size(), nullptr, false);
  if (!report.is_object() || !report.contains("files")) return Error{path, "is not a report written by citykiln"};
  std::uint64_t sum = report.value("bytes", std::uint64_t{0});
  for (const outputs::WrittenFile& file : files) {
    sum += file.bytes;
    report["files"].push_back({{"file", file.name}, {"bytes", file.bytes}});
  }
  report["bytes"] = sum;
  return report.dump(1) + "\n";
}

Result<Done> keep_files(const std::string& path, const exporters::FileList& list, exporters::OutputFolder& folder) {
  for (const exporters::ListedFile& file : list)
    if (file.name != exporters::kReportName)
      if (const Result<Done> done = folder.adopt(file, path + "/" + file.name); !done) return done;
  return Done{};
}

/// Bakes the tileset if it is missing, and writes the page.
Result<std::vector<outputs::WrittenFile>> write_missing(const scene::Scene& scene, const Outputs& outputs, int threads,
                                                        bool has_tileset, exporters::OutputFolder& folder,
                                                        const OnProgress& on_progress) {
  const Result<map::Geoid> geoid = outputs::geoid_of(scene.header, outputs);
  if (!geoid) return geoid.error();
  std::vector<outputs::WrittenFile> files;
  Report of_tileset;
  if (!has_tileset) {
    Result<std::vector<outputs::MaterialSet>> sets = outputs::sets_of(outputs);
    if (!sets) return sets.error();
    const outputs::TextureChoice textures(outputs, scene.header.seed, *sets);
    auto tileset = outputs::write_tiles3d(scene, outputs, *geoid, textures, threads, folder, of_tileset, on_progress);
    if (!tileset) return tileset.error();
    files = std::move(*tileset);
  }
  auto page = outputs::write_page(scene, outputs, *geoid, threads, folder);
  if (!page) return page.error();
  files.insert(files.end(), page->begin(), page->end());
  return files;
}

Result<Done> add_to_run(const PageRequest& request, const exporters::FileList& list, const Console& console) {
  const Result<outputs::RunRecord> record = outputs::read_report(request.folder);
  if (!record) return record.error();
  if (!exporters::has_file(list, exporters::kManifestName)) return missing_manifest(request.folder);
  const Result<scene::Scene> scene = exporters::read_manifest(request.folder + "/" + exporters::kManifestName, {});
  if (!scene) return scene.error();
  Result<exporters::OutputFolder> folder = exporters::OutputFolder::open(request.folder);
  if (!folder) return folder.error();

  const InterruptNotice notice(kRunAsBefore);
  const Outputs outputs = outputs_of(request, *record);
  if (const Result<Done> done = keep_files(request.folder, list, *folder); !done) return done;
  const auto files =
      write_missing(*scene, outputs, request.threads, exporters::has_file(list, kTileset), *folder, console.progress());
  if (!files) return files.error();
  const Result<std::string> report = report_with(request.folder, *files);
  if (!report) return report.error();
  if (const auto done = folder->write(exporters::kReportName, exporters::bytes_of(*report)); !done) return done;
  return folder->commit();
}

}  // namespace

Result<Done> complete_page(const PageRequest& request, const Console& console) {
  if (const Result<Done> done = exporters::finish_commit(request.folder); !done) return done;
  const auto list = exporters::read_file_list(request.folder + "/" + exporters::kFileListName);
  if (!list) return list.error();
  if (!*list) return Error{request.folder, "holds no finished run; expected the folder that compile wrote"};
  const bool has_tileset = exporters::has_file(**list, kTileset);
  if (has_tileset && exporters::has_file(**list, exporters::kPageName)) return Done{};
  console.print_line(fmt::format("{}: {}", request.folder,
                                 has_tileset ? "writing the page" : "baking the tileset and writing the page"));
  return add_to_run(request, **list, console);
}

}  // namespace citykiln::commands
