// Parses argv and runs a verb. This is the only file that includes the command line parser, CLI11.
#pragma once

#include <span>

#include "compiler/commands/verb.h"

namespace citykiln::commands {

/// Runs the verb named by argv. Prints errors as one line on stderr. Returns the program's exit code.
int run(std::span<const Verb> verbs, int argc, const char* const* argv);

}  // namespace citykiln::commands
