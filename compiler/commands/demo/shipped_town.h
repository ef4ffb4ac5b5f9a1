// Finds the example town that is shipped with the program, reads its settings, and tests whether it is compiled.
#pragma once

#include <string>

#include "compiler/contract/result.h"
#include "compiler/spec.h"

namespace citykiln::commands {

/// Returns the folder of the example town, found from the folder of the running program:
/// ../share/citykiln/examples/town, as installed, else ../../examples/town, for a program in build/PRESET of the source
/// tree. Error: neither has a spec.json.
Result<std::string> shipped_town();

/// Reads spec.json of the town's folder. Its map and heightmaps are replaced by the files of their names in that
/// folder. Errors: a spec.json that is missing or wrong.
Result<CompileSpec> read_town(const std::string& town_folder);

/// Tests whether the output folder of the settings (spec.outputs.folder) holds a run that is newer than its inputs:
/// spec.json, map, heightmaps and the program. Other settings are not compared. Not read-only: it first finishes an
/// interrupted commit there (exporters/finish_commit.h). Errors: those of that; a run of other sources.
/// @param town_folder  The folder of the inputs, not of the run.
Result<bool> has_fresh_run(const CompileSpec& spec, const std::string& town_folder);

}  // namespace citykiln::commands
