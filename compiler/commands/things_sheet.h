// A picture of all things, each at three tolerances.
#pragma once

#include <string>

#include "compiler/commands/console.h"
#include "compiler/contract/result.h"

namespace citykiln::commands {

/// Draws the things of the shipped table, with those of a folder ("" for none), each in its default size at 2, 10 and
/// 50 cm, four things in a row, and prints a line for each row of the sheet. Errors: those of the table and the rules,
/// and of writing the picture.
Result<Done> draw_things_sheet(const std::string& folder, const std::string& path, const Console& console);

}  // namespace citykiln::commands
