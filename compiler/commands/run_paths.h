// The manifest and the folder of a run, given either of them.
#pragma once

#include <string>

#include "compiler/contract/result.h"

namespace citykiln::commands {

/// Returns "OUT/scene.kiln" for "OUT", the folder of a run; any other path unchanged. The manifest is the file
/// with the scene. Changes the folder, also for "OUT/scene.kiln": if a run was interrupted while its complete files
/// were moved into the folder, the function first moves the others (exporters/settle_folder.h). Errors: a folder
/// without a manifest; files that cannot be moved.
Result<std::string> settle_and_find_manifest(const std::string& path);

/// Returns "OUT" for "OUT/scene.kiln" and "." for "scene.kiln"; any other path unchanged.
std::string folder_of(const std::string& path);

}  // namespace citykiln::commands
