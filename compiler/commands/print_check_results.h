// Prints the results of `check`.
#pragma once

#include "compiler/commands/console.h"
#include "compiler/verify/check_results.h"

namespace citykiln::commands {

/// Prints one line per guarantee and measure, or one JSON array.
void print(const verify::CheckResults& results, const Console& console);

}  // namespace citykiln::commands
