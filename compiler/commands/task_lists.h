// The tasks of a plan for engines that run them: build.ninja for Ninja, submit.sh and task.sh for Slurm.
#pragma once

#include <map>
#include <string>

#include "compiler/commands/plan_file.h"

namespace citykiln::commands {

/// Quotes a text for a POSIX shell as one word, whatever it holds.
std::string shell_quoted(const std::string& text);
/// Escapes a path for the right and left side of a build statement of Ninja. A line break cannot be written there: it
/// becomes a space.
std::string ninja_path(const std::string& path);
/// Escapes a command for a rule of Ninja.
std::string ninja_command(const std::string& command);

/// Returns the scripts of a plan by file name. They are run in the folder of the plan, wherever that is.
///
/// build.ninja: a target for each region, state/X_Y.json, and gather after all of them; each task has one thread.
/// submit.sh: job arrays of at most kLargestArray tasks, one or more for each class of memory (1, 2, 4 … GB, half more
/// than expected), requeued when their node fails and, up to 3 times, when a task was killed; gather runs after all,
/// whether they succeeded or not.
/// @param program  The path of citykiln, the same on all nodes.
std::map<std::string, std::string> task_lists(const Plan& plan, const std::string& program);

/// Slurm's MaxArraySize is 1001 by default.
inline constexpr std::size_t kLargestArray = 1000;

}  // namespace citykiln::commands
