// citykiln plan --status PLAN: how far the tasks of a plan are.
#pragma once

#include <string>

#include "compiler/commands/verb.h"

namespace citykiln::commands {

/// Prints the number of regions in each state, the core hours left by the model, scaled by the tasks done so far, and
/// one line for each failed region. With --json: one object for each region.
/// @param geojson  Writes the regions as polygons with their states (RFC 7946); "" for none.
Result<Exit> print_status(const std::string& plan_folder, const std::string& geojson, const Console& console);

}  // namespace citykiln::commands
