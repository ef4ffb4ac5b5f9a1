// Parses argv and runs a verb. This is the only file that includes the command line parser, CLI11.
#pragma once

#include <span>

#include "compiler/commands/verb.h"

namespace citykiln::commands {

/// Runs the verb named by argv, such as compile or preview. Prints errors as one line on stderr; with --json on the
/// command line, output is JSON. Returns the program's exit code (Exit): kFailed also for an unknown verb or option.
/// @param argv  The program's name, then its arguments. argc > 0.
int run(std::span<const Verb> verbs, int argc, const char* const* argv);

}  // namespace citykiln::commands
