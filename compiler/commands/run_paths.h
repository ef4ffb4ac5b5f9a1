// The files of a run, by the folder or by a file in it.
#pragma once

#include <string>

#include "compiler/contract/result.h"

namespace citykiln::commands {

/// "OUT/scene.kiln" for the folder of a run, "OUT"; any other path as it is. Finishes an interrupted commit of the
/// folder first, also for "OUT/scene.kiln". Error: a folder without a manifest.
Result<std::string> manifest_of(const std::string& path);

/// "OUT" for "OUT/scene.kiln", "." for "scene.kiln"; any other path as it is.
std::string folder_of(const std::string& path);

}  // namespace citykiln::commands
