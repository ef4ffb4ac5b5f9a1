// citykiln compile --plan PLAN --region X_Y: the task that compiles one region of a plan.
#pragma once

#include <string>

#include "compiler/commands/compile_request.h"
#include "compiler/commands/plan/plan_file.h"
#include "compiler/commands/verb.h"

namespace citykiln::commands {

/// Compiles a region of a plan into PLAN/regions/X_Y, and returns the Exit of that compile. If an earlier task of this
/// program has done so from equal inputs and settings, and the outputs exist, prints that and returns kDone at once.
/// Continues an interrupted task. Changes the working folder of the process to that of the plan.
///
/// @param region  The region's name, "X_Y".
/// @param own     Settings besides those of the plan; only --threads is allowed.
///
/// Errors: a folder that is no plan, a region that it has not; other settings than --threads; a survey or inputs that
/// cannot be read; those of compiling. All but the first two are also written to the state of the region
/// (region_state.h).
Result<Exit> compile_region(const std::string& plan_folder, const std::string& region, const CompileRequest& own,
                            const Console& console);

}  // namespace citykiln::commands
