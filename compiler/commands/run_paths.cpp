#include "compiler/commands/run_paths.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "exporters/finish_commit.h"
#include "exporters/run_files.h"

namespace citykiln::commands {

namespace fs = std::filesystem;

Result<std::string> find_committed_manifest(const std::string& path) {
  // files of other kinds are read, and refused, by those who asked
  std::error_code missing;
  if (!fs::exists(path, missing)) {
    const Result<Done> there = check_run_path(path);
    if (!there) return there.error();
  }
  const std::string folder = folder_of(path);
  std::error_code none;
  if (!fs::is_directory(folder, none)) return path;
  if (const Result<Done> done = exporters::finish_commit(folder); !done) return done.error();
  if (folder != path) return path;
  const std::string manifest = (fs::path(folder) / exporters::kManifestName).string();
  if (!fs::exists(manifest, none)) return missing_manifest(folder);
  return manifest;
}

bool is_map_name(std::string_view path) {
  constexpr std::string_view kEndings[] = {".osm", ".osm.gz", ".osm.bz2", ".pbf"};
  return std::ranges::any_of(kEndings, [&](std::string_view ending) { return path.ends_with(ending); });
}

Result<Done> check_run_path(const std::string& path) {
  std::error_code none;
  if (!fs::exists(path, none))
    return Error{path, "there is no such file or folder; expected the folder that compile wrote, such as out/town"};
  if (!fs::is_directory(path, none) && is_map_name(path))
    return Error{path, fmt::format("is a map; compile it first: citykiln compile {} -o out", path)};
  return Done{};
}

Error missing_manifest(const std::string& folder) {
  std::error_code none;
  if (fs::exists(fs::path(folder) / exporters::kReportName, none))
    return {folder, fmt::format("was written without its manifest, {}; compile again with kiln among --emit, such as "
                                "--emit kiln,3dtiles",
                                exporters::kManifestName)};
  return {folder, fmt::format("holds no {}; expected the folder of a finished run", exporters::kManifestName)};
}

Result<Done> check_output_file(const std::string& path, std::initializer_list<std::string_view> endings) {
  const bool fits = endings.size() == 0 ||
                    std::ranges::any_of(endings, [&](std::string_view ending) { return path.ends_with(ending); });
  if (!fits) return Error{path, fmt::format("expected a name that ends in {}", fmt::join(endings, " or "))};
  std::error_code none;
  if (fs::is_directory(path, none)) return Error{path, "cannot be written: there is a folder of this name"};
  const fs::path parent = fs::path(path).parent_path();
  const std::string folder = parent.empty() ? "." : parent.string();
  if (!fs::is_directory(folder, none))
    return Error{path, fmt::format("cannot be written: there is no folder {}; create it first", folder)};
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    return Error{path, fmt::format("cannot be written: the folder {} is write-protected", folder)};
  return Done{};
}

Result<Done> make_output_folder(const std::string& folder) {
  std::error_code problem;
  fs::create_directories(folder, problem);
  if (problem || !fs::is_directory(folder, problem))
    return Error{folder, "cannot be created as a folder" + (problem ? ": " + problem.message() : std::string())};
  if (access(folder.c_str(), W_OK | X_OK) != 0) return Error{folder, "cannot be written: it is write-protected"};
  return Done{};
}

std::string folder_of(const std::string& path) {
  if (fs::path(path).filename() != exporters::kManifestName) return path;
  const fs::path folder = fs::path(path).parent_path();
  return folder.empty() ? "." : folder.string();
}

}  // namespace citykiln::commands
