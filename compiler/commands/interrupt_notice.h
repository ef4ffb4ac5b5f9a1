// Prints a message when a command is interrupted by Ctrl-C or by a system that shuts down.
#pragma once

#include <string>
#include <string_view>

namespace citykiln::commands {

/// The words of an interrupted command that only reads, or has not written yet.
inline constexpr std::string_view kNothingWritten = "nothing was written";
/// The words of one that writes a run to a folder.
inline constexpr std::string_view kRunAsBefore =
    "the output folder holds the earlier run, if there was one, and the same command goes on with the tiles baked so "
    "far";

/// During its lifetime, SIGINT and SIGTERM print one line on stderr, "citykiln: interrupted; " and a text, and end the
/// process at once with exit code 128 + signal. Nothing needs to be undone, since the folder of a run is valid at every
/// moment (exporters/output_folder.h). The text of an inner object replaces that of the outer one. Objects are
/// destroyed in the reverse order of their creation.
class InterruptNotice {
 public:
  explicit InterruptNotice(std::string_view text);
  ~InterruptNotice();
  InterruptNotice(const InterruptNotice&) = delete;
  InterruptNotice& operator=(const InterruptNotice&) = delete;

 private:
  std::string line_;
  const std::string* outer_;
};

}  // namespace citykiln::commands
