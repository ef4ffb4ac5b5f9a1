// Completion of the command line in bash, made from the tables of the verbs.
#pragma once

#include <span>
#include <string>

#include "compiler/commands/verb.h"

namespace citykiln::commands {

/// Returns a script for /usr/share/bash-completion/completions. It completes verbs, the flags of a verb, and values
/// whose table lists them, such as "none|quantize|draco|meshopt", also one after another in lists such as "kiln,glb";
/// elsewhere bash completes files. Hidden verbs
/// are left out.
std::string bash_completion(std::span<const Verb> verbs);

}  // namespace citykiln::commands
