// From argv to a verb's run. The only file that sees the library that parses command lines (CLI11).
#pragma once

#include <span>

#include "compiler/commands/verb.h"

namespace citykiln::commands {

/// Runs the verb that argv names. Errors are one line on stderr. Returns the program's exit code.
int run(std::span<const Verb> verbs, int argc, const char* const* argv);

}  // namespace citykiln::commands
