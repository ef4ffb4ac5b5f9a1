// What a run says: sentences for people, JSON for machines, a progress bar where somebody watches.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "compiler/stage_timer.h"

namespace citykiln::commands {

struct Console {
  bool is_json = false;   ///< --json: the answer is one JSON document on stdout, and nothing else is.
  bool is_quiet = false;  ///< --quiet: nothing but errors.

  /// A line for people, on stdout.
  void print_line(std::string_view line) const;
  /// The answer for machines, on stdout.
  void print_json(std::string_view json) const;
  /// A bar on stderr, from one second on, if stderr is a terminal and nobody asked for silence. The bar is gone when
  /// the last copy of what this returns is.
  OnProgress progress() const;
};

}  // namespace citykiln::commands
