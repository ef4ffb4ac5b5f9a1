// Prints a message when a command is interrupted by Ctrl-C or by a system that shuts down.
#pragma once

#include <string>
#include <string_view>

namespace citykiln::commands {

/// Text of InterruptNotice for a command that only reads, or has not written yet.
inline constexpr std::string_view kNothingWritten = "nothing was written";
/// Text of InterruptNotice for a command that writes a run to a folder.
inline constexpr std::string_view kRunAsBefore =
    "the output folder holds the earlier run, if there was one, and the same command goes on with the tiles baked so "
    "far";

/// While one exists, SIGINT and SIGTERM print one line on stderr, "citykiln: interrupted; " and its text, and end the
/// process at once with exit code 128 + signal. No destructor runs: what a caller writes is valid at every moment, as
/// the folder of a run is (exporters/output_folder.h), or the text says what is not. Notices nest: the innermost text
/// is printed; the last one created is destroyed first. Afterwards both signals have their default action.
class InterruptNotice {
 public:
  /// @param text  Copied; without a line break.
  explicit InterruptNotice(std::string_view text);
  ~InterruptNotice();
  InterruptNotice(const InterruptNotice&) = delete;
  InterruptNotice& operator=(const InterruptNotice&) = delete;

 private:
  std::string line_;
  const std::string* outer_;  // the line of the notice around this one; null for the outermost
};

}  // namespace citykiln::commands
