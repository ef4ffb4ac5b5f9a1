// A verb of the command line as a table: its options, and the function that runs it. Only command_line.cpp includes the
// command line parser.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "compiler/commands/console.h"
#include "compiler/contract/result.h"
#include "compiler/spec.h"

namespace citykiln::commands {

/// The program's exit codes. kFailed belongs to an Error.
enum class Exit : int { kDone = 0, kFailed = 1, kStrictViolation = 2 };

/// Takes the text of an option's value.
using Take = std::function<Result<Done>(const std::string& text)>;

/// One option of a verb.
struct Option {
  std::string flags;  ///< "-o,--out"; a name without dashes is a positional argument.
  /// Name of the value in the help, "FILE"; empty for a switch, which passes "true"; "[=CODE]" for a switch that can
  /// have a value.
  std::string value;
  std::string help;
  bool repeats = false;
  Take take;                   ///< Called for each value, in the order of the table.
  bool takes_several = false;  ///< Several values may follow the flag once.
};

struct Verb {
  std::string name, help;
  std::vector<Option> options;
  std::function<Result<Exit>(const Console& console)> run;  ///< Called after all options were taken.
  std::vector<std::string> examples{};                      ///< Whole command lines for the help.
};

Verb compile_verb();
Verb bake_verb();
Verb preview_verb();
Verb inspect_verb();
Verb check_verb();
Verb chart_verb();
Verb plan_verb();
Verb gather_verb();

/// The numbers above `low` and below `high`; both are included if the range is closed.
struct NumberRange {
  double low = 0, high = std::numeric_limits<double>::infinity();
  bool is_closed = false;
};

/// Stores the text. The reference must outlive the option, here and in the functions below.
Take store_text(std::string& text);
/// Appends the text to a list.
Take append_text(std::vector<std::string>& texts);
/// Stores a number of the range.
Take store_number(double& number, NumberRange range);
Take store_number(std::optional<double>& number, NumberRange range);
/// Stores a tolerance: metres above 0, at most kCoarsest_m.
Take store_tolerance(double& tolerance_m);
Take store_tolerance(std::optional<double>& tolerance_m);
/// Stores an integer of at least `least`.
template <typename Whole>
Take store_whole(Whole& number, int least) {
  return [&number, least](const std::string& text) -> Result<Done> {
    const Result<std::int64_t> whole = parse_whole(text, least);
    if (!whole) return whole.error();
    number = static_cast<Whole>(*whole);
    return Done{};
  };
}

/// The option --threads, the same for all verbs.
Option threads_option(int& threads);

}  // namespace citykiln::commands
