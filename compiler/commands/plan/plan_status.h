// citykiln plan --status PLAN: the progress of the tasks of a plan.
#pragma once

#include <string>

#include "compiler/commands/verb.h"

namespace citykiln::commands {

/// Prints the number of regions in each state, the remaining core hours, and one line per failed region. The remaining
/// hours are the expected hours of unfinished tasks, scaled by the ratio of real to expected hours of finished ones.
/// With --json prints one document: a list with an object per region, and the remaining seconds.
///
/// @param geojson  The file to which the regions and their states are written as polygons (RFC 7946); "" for none.
///
/// Errors: a folder that is no plan; a file that cannot be written.
Result<Exit> print_status(const std::string& plan_folder, const std::string& geojson, const Console& console);

}  // namespace citykiln::commands
