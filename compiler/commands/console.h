// Prints lines of text, JSON documents and a progress bar.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/stage_timer.h"

namespace citykiln::commands {

/// The output of a command.
struct Console {
  bool is_json = false;   ///< --json: prints one JSON value on stdout and nothing else.
  bool is_quiet = false;  ///< --quiet: prints errors only.

  /// Prints a line on stdout, unless is_json or is_quiet.
  void print_line(std::string_view line) const;
  /// Keeps a JSON value for end_json() if is_json.
  void print_json(std::string_view json) const;
  /// Prints an error as one line on stderr. If is_json, also keeps an object for end_json():
  /// {"error": {"file": …, "place": …, "message": …}}.
  /// File and place are null if the error has none. The file is a path; the place is a line and column, a byte, a tile,
  /// or an option.
  void print_error(const Error& error) const;
  /// Prints exactly one JSON value on stdout if is_json: the value that was kept, several as a list, {} if there was
  /// none. After an error, the error's object, in which the others are "result". Later values are not printed.
  void end_json() const;
  /// Returns a function that shows progress on stderr after one second, if stderr is a terminal and the console is
  /// neither quiet nor JSON: the stage, a bar of its share and the time left. A stage that stays at 0 shows its time so
  /// far; an empty one hides the line. The line is redrawn by a thread, gives way to other lines of the console, and is
  /// erased when the last copy of the function is destroyed. The function is thread-safe.
  OnProgress progress() const;

  /// The values and the error of print_json() and print_error(). Copies of a console share it.
  struct Kept {
    std::vector<std::string> values;
    std::string error;
    bool is_printed = false;
  };
  std::shared_ptr<Kept> kept = std::make_shared<Kept>();
};

}  // namespace citykiln::commands
