#include "compiler/commands/demo/shipped_town.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "exporters/file.h"
#include "exporters/finish_commit.h"
#include "exporters/run_files.h"

namespace citykiln::commands {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSpecName = "spec.json";
/// The folders that may hold the town, relative to the folder of the program.
constexpr const char* kTownFolders[] = {"../share/citykiln/examples/town", "../../examples/town"};

fs::path running_program() {
  std::error_code none;
  return fs::read_symlink("/proc/self/exe", none);
}

std::string file_in(const std::string& folder, const std::string& path) {
  return (fs::path(folder) / fs::path(path).filename()).string();
}

/// The maps and heightmaps of settings, as report.json names them.
std::vector<std::string> sources_of(const CompileSpec& spec) {
  std::vector<std::string> names = {fs::path(spec.map_path).filename().string()};
  for (const source::RasterSpec& raster : spec.rasters) names.push_back(fs::path(raster.path).filename().string());
  return names;
}

/// The maps and heightmaps of the run in a folder; empty if its report cannot be read.
std::vector<std::string> sources_in(const std::string& report_path) {
  const Result<std::vector<std::byte>> bytes = exporters::read_file(report_path);
  if (!bytes) return {};
  const auto* text = reinterpret_cast<const char*>(bytes->data());
  const auto report = nlohmann::json::parse(text, text + bytes->size(), nullptr, false);
  std::vector<std::string> names;
  if (!report.is_object() || !report.contains("sources")) return names;
  for (const auto& name : report["sources"])
    if (name.is_string()) names.push_back(name);
  return names;
}

bool is_older_than(const fs::path& file, fs::file_time_type time) {
  std::error_code problem;
  const auto written = fs::last_write_time(file, problem);
  return !problem && written < time;
}

}  // namespace

Result<std::string> shipped_town() {
  std::error_code none;
  for (const char* folder : kTownFolders) {
    const fs::path town = (running_program().parent_path() / folder).lexically_normal();
    if (fs::exists(town / kSpecName, none)) return town.string();
  }
  return Error{"", fmt::format("the example town is missing; expected the folder {} beside {}", kTownFolders[0],
                               running_program().string())};
}

Result<CompileSpec> read_town(const std::string& town) {
  Result<CompileSpec> spec = read_spec((fs::path(town) / kSpecName).string());
  if (!spec) return spec;
  spec->map_path = file_in(town, spec->map_path);
  for (source::RasterSpec& raster : spec->rasters) raster.path = file_in(town, raster.path);
  return spec;
}

Result<bool> has_fresh_run(const CompileSpec& spec, const std::string& town) {
  const std::string& folder = spec.outputs.folder;
  const fs::path report = fs::path(folder) / exporters::kReportName;
  std::error_code missing;
  if (!fs::is_directory(folder, missing)) return false;
  if (const Result<Done> done = exporters::finish_commit(folder); !done) return done.error();
  if (!fs::exists(report, missing)) return false;
  const std::vector<std::string> sources = sources_in(report.string());
  if (sources != sources_of(spec))
    return Error{folder, fmt::format("holds a run of another map, {}; give another folder with -o",
                                     fmt::join(sources, " and "))};
  const auto made = fs::last_write_time(report, missing);
  std::vector<fs::path> inputs = {running_program(), fs::path(town) / kSpecName, spec.map_path};
  for (const source::RasterSpec& raster : spec.rasters) inputs.emplace_back(raster.path);
  return fs::exists(fs::path(folder) / exporters::kManifestName, missing) &&
         std::ranges::all_of(inputs, [&](const fs::path& input) { return is_older_than(input, made); });
}

}  // namespace citykiln::commands
