// citykiln compile --plan PLAN --region X_Y: the task of one region.
#pragma once

#include <string>

#include "compiler/commands/compile_request.h"
#include "compiler/commands/plan_file.h"
#include "compiler/commands/verb.h"

namespace citykiln::commands {

/// Compiles a region of a plan into PLAN/regions/X_Y. Returns at once, saying so, where this program has done it from
/// the same inputs and settings and the outputs are there. Goes on where an interrupted task ended.
/// @param own  Settings besides those of the plan; only --threads may be given.
/// Errors are written to the state of the region too (region_state.h).
Result<Exit> compile_region(const std::string& plan_folder, const std::string& region, const CompileRequest& own,
                            const Console& console);

}  // namespace citykiln::commands
