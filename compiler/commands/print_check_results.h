// The findings of `check` on the console.
#pragma once

#include "compiler/commands/console.h"
#include "compiler/verify/check_results.h"

namespace citykiln::commands {

/// Prints one line a promise for people, or the same as one JSON array for machines.
void print(const verify::CheckResults& results, const Console& console);

}  // namespace citykiln::commands
