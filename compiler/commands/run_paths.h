// The manifest and the folder of a run, given either of them.
#pragma once

#include <string>

#include "compiler/contract/result.h"

namespace citykiln::commands {

/// Returns "OUT/scene.kiln" for "OUT", the folder of a run; any other path unchanged. First finishes an interrupted
/// commit of the folder, also for "OUT/scene.kiln". Error: a folder without a manifest.
Result<std::string> manifest_of(const std::string& path);

/// Returns "OUT" for "OUT/scene.kiln" and "." for "scene.kiln"; any other path unchanged.
std::string folder_of(const std::string& path);

}  // namespace citykiln::commands
