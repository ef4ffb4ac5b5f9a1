// The example town that is shipped with the program, and runs of it.
#pragma once

#include <string>

#include "compiler/contract/result.h"
#include "compiler/spec.h"

namespace citykiln::commands {

/// Returns the folder of the example town: share/citykiln/examples/town of the installation that the running program
/// belongs to, wherever that was moved; or examples/town of the source tree, for a program in build/PRESET. Error: it
/// is in neither.
Result<std::string> shipped_town();

/// Returns the settings of the town, whose files are those in its folder. Errors: a spec.json that is missing or wrong.
Result<CompileSpec> read_town(const std::string& town);

/// Tests whether a folder holds a run of these settings that is newer than their files and than the program. First
/// finishes an interrupted commit (exporters/finish_commit.h). Error: it holds a run of another map.
Result<bool> has_fresh_run(const CompileSpec& spec, const std::string& town);

}  // namespace citykiln::commands
