// A verb of the command line as a table: its options, and what it does. Only command_line.cpp knows the library that
// parses them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "compiler/commands/console.h"
#include "compiler/contract/result.h"

namespace citykiln::commands {

/// The program's exit codes. An Error is 1.
enum class Exit : int { kDone = 0, kFailed = 1, kStrictViolation = 2 };

/// One option of a verb.
struct Option {
  std::string flags;  ///< "-o,--out"; a word without dashes stands by its place.
  std::string value;  ///< How its value is written, "FILE"; empty for a switch, which hands over "true".
  std::string help;
  bool repeats = false;
  std::function<Result<Done>(const std::string& text)> take;  ///< Called once a value, in the order of the table.
};

struct Verb {
  std::string name, help;
  std::vector<Option> options;
  std::function<Result<Exit>(const Console& console)> run;  ///< After all options were taken.
};

Verb compile_verb();
Verb bake_verb();
Verb preview_verb();
Verb inspect_verb();
Verb check_verb();
Verb chart_verb();

/// An option's take that keeps the text.
std::function<Result<Done>(const std::string&)> store_text(std::string& text);
/// One that wants a whole number, `least` or more.
std::function<Result<Done>(const std::string&)> store_whole(int& number, int least);
/// Adds the text to a list.
std::function<Result<Done>(const std::string&)> append_text(std::vector<std::string>& texts);

/// --threads, as all verbs have it.
Option threads_option(int& threads);

}  // namespace citykiln::commands
