// Compares the folder of a run with its list of files.
#pragma once

#include "compiler/contract/result.h"
#include "compiler/verify/check_results.h"
#include "compiler/verify/check_tile.h"

namespace citykiln::verify {

/// Tests that every file that files.json lists has its size and hash, that report.json names listed files, and that no
/// other file in the folder has a name that a run gives. Adds the other files to results.unlisted. Cost: reads every
/// file. Error: a files.json that is not a list of files.
Result<Done> check_folder(const LoadedRun& run, int threads, CheckResults& results);

/// True for names that a run gives to files, such as "scene.kiln", "glb/3_-2_L0.glb" or "report.json". False for
/// "index.html": `check --worst` and users write files of this name too.
bool is_name_of_run(const std::string& name);

}  // namespace citykiln::verify
