// A verb of the command line as a table: its options, and the function that runs it. Only command_line.cpp includes the
// command line parser.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "compiler/commands/console.h"
#include "compiler/contract/result.h"

namespace citykiln::commands {

/// The program's exit codes. kFailed belongs to an Error.
enum class Exit : int { kDone = 0, kFailed = 1, kStrictViolation = 2 };

/// One option of a verb.
struct Option {
  std::string flags;  ///< "-o,--out"; a name without dashes is a positional argument.
  std::string value;  ///< Name of the value in the help, "FILE"; empty for a switch, which passes "true".
  std::string help;
  bool repeats = false;
  std::function<Result<Done>(const std::string& text)> take;  ///< Called for each value, in the order of the table.
};

struct Verb {
  std::string name, help;
  std::vector<Option> options;
  std::function<Result<Exit>(const Console& console)> run;  ///< Called after all options were taken.
};

Verb compile_verb();
Verb bake_verb();
Verb preview_verb();
Verb inspect_verb();
Verb check_verb();
Verb chart_verb();

/// Returns a `take` function that stores the text. The reference must outlive the option; so in all functions below.
std::function<Result<Done>(const std::string&)> store_text(std::string& text);
/// Stores an integer of at least `least`.
std::function<Result<Done>(const std::string&)> store_whole(int& number, int least);
/// Appends the text to a list.
std::function<Result<Done>(const std::string&)> append_text(std::vector<std::string>& texts);

/// The option --threads, the same for all verbs.
Option threads_option(int& threads);

}  // namespace citykiln::commands
