// Compares the folder of a run with its list of files.
#pragma once

#include "compiler/contract/result.h"
#include "compiler/verify/check_results.h"
#include "compiler/verify/check_tile.h"

namespace citykiln::verify {

/// Tests that every listed file is whole, that report.json names listed files, and that no other file has a name that a
/// run gives; lists the files that are not of the run. Cost: reads every file. Error: a files.json that is no list.
Result<Done> check_folder(const LoadedRun& run, int threads, CheckResults& results);

/// Whether runs write files of this name: "scene.kiln", "glb/3_-2_L0.glb", "report.json" …
bool is_name_of_run(const std::string& name);

}  // namespace citykiln::verify
