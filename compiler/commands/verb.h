// The verbs of the command line (such as `compile`) as tables: options, and a function that runs the verb.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/commands/console.h"
#include "compiler/commands/interrupt_notice.h"
#include "compiler/contract/result.h"
#include "compiler/parse_values.h"

namespace citykiln::commands {

/// The exit codes of the program. A verb that returns an Error ends with kFailed.
enum class Exit : int { kDone = 0, kFailed = 1, kStrictViolation = 2 };

/// A function that parses and stores the value of an option.
using StoreValue = std::function<Result<Done>(const std::string& text)>;

/// One option of a verb.
struct Option {
  std::string flags;  ///< "-o,--out"; a name without dashes is a positional argument.
  /// The name of the value in the help, such as "FILE"; empty for a switch, which passes "true"; "[=CODE]" for a switch
  /// with an optional value.
  std::string value;
  std::string help;
  bool repeats = false;
  StoreValue store;            ///< Called for each value, in the order of the table.
  bool takes_several = false;  ///< Several values may follow one flag.
};

/// A verb of the command line, such as `compile`.
struct Verb {
  std::string name, help;
  std::vector<Option> options;
  std::function<Result<Exit>(const Console& console)> run;  ///< Called after all options are stored.
  std::vector<std::string> examples{};                      ///< Complete command lines for the help.
  bool is_hidden = false;                                   ///< Not in the help: for builds of packages.
  std::string_view interrupted = kNothingWritten;           ///< The words of Ctrl-C, unless run() has others.
};

/// A switch that every verb has.
struct SharedSwitch {
  const char *flag, *help;
};
inline constexpr SharedSwitch kJson = {"--json", "print the result as one JSON document"};
inline constexpr SharedSwitch kQuiet = {"--quiet", "print errors only"};
inline constexpr SharedSwitch kHelp = {"--help", "print the options and examples"};

/// Returns the verb of this name, here and below.
Verb compile_verb();
Verb bake_verb();
Verb preview_verb();
Verb inspect_verb();
Verb check_verb();
Verb plan_verb();
Verb gather_verb();
/// @param verbs  The verbs that the manual page, or the completion, describes.
Verb man_verb(std::vector<Verb> verbs);
Verb completion_verb(std::vector<Verb> verbs);
Verb addon_verb();
Verb view_verb();
Verb serve_verb();
Verb invent_verb();
Verb demo_verb();

/// A range of numbers. Both ends are included if it is closed, else neither.
struct NumberRange {
  double low = 0, high = std::numeric_limits<double>::infinity();
  bool is_closed = false;
};

/// Returns a function that stores the text in a variable. The variable must outlive the option, here and below.
StoreValue store_text(std::string& text);
/// Returns a function that appends the text to a list.
StoreValue append_text(std::vector<std::string>& texts);
/// Returns a function that stores a number, if it is in the range.
StoreValue store_number(double& number, NumberRange range);
StoreValue store_number(std::optional<double>& number, NumberRange range);
/// Returns a function that stores a tolerance: metres above 0, at most kCoarsest_m.
StoreValue store_tolerance(double& tolerance_m);
StoreValue store_tolerance(std::optional<double>& tolerance_m);
/// Returns a function that stores an integer from `least` to 2^31 - 1, which the type must hold.
template <typename Whole>
StoreValue store_whole(Whole& number, int least) {
  return [&number, least](const std::string& text) -> Result<Done> {
    const Result<std::int64_t> whole = parse_whole(text, least);
    if (!whole) return whole.error();
    number = static_cast<Whole>(*whole);
    return Done{};
  };
}

/// Returns the option --threads, which all verbs share.
Option threads_option(int& threads);

}  // namespace citykiln::commands
