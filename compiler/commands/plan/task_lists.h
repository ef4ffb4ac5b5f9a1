// The tasks of a plan as files for programs that run them: build.ninja for Ninja, submit.sh and task.sh for Slurm.
#pragma once

#include <map>
#include <string>

#include "compiler/commands/plan/plan_file.h"

namespace citykiln::commands {

/// Quotes any text as one word of a POSIX shell.
std::string shell_quoted(const std::string& text);
/// Escapes a command for a rule of a Ninja file. A line break, which Ninja cannot express, becomes a space.
std::string ninja_command(const std::string& command);

/// Returns the scripts of a plan by file name. They are run in the folder of the plan, which can be moved.
///
/// build.ninja: a target per region, state/X_Y.json, and `gather` after all of them. Each task has one thread.
/// submit.sh: job arrays of at most kLargestArray tasks, one or more per class of memory (1, 2, 4 … GB, at least twice
/// the expected memory). Tasks are requeued when their node fails and, up to 3 times, when they are killed. `gather`
/// runs after all tasks, even if some failed.
/// @param program  The path of citykiln, which must be the same on all nodes.
std::map<std::string, std::string> task_lists(const Plan& plan, const std::string& program);

/// Slurm's MaxArraySize is 1001 by default.
inline constexpr std::size_t kLargestArray = 1000;

}  // namespace citykiln::commands
