#include "compiler/commands/run_paths.h"

#include <fmt/format.h>

#include <filesystem>

#include "exporters/run_files.h"
#include "exporters/settle_folder.h"

namespace citykiln::commands {

namespace fs = std::filesystem;

Result<std::string> settle_and_find_manifest(const std::string& path) {
  const std::string folder = folder_of(path);
  std::error_code none;
  if (!fs::is_directory(folder, none)) return path;
  if (const Result<Done> done = exporters::settle(folder); !done) return done.error();
  if (folder != path) return path;
  const std::string manifest = (fs::path(folder) / exporters::kManifestName).string();
  if (!fs::exists(manifest, none))
    return Error{folder, fmt::format("holds no {}; expected the folder of a finished run", exporters::kManifestName)};
  return manifest;
}

std::string folder_of(const std::string& path) {
  if (fs::path(path).filename() != exporters::kManifestName) return path;
  const fs::path folder = fs::path(path).parent_path();
  return folder.empty() ? "." : folder.string();
}

}  // namespace citykiln::commands
