// Prints a message when a run is interrupted by Ctrl-C or by a system that shuts down.
#pragma once

namespace citykiln::commands {

/// During its lifetime, SIGINT and SIGTERM print a line on stderr that says what remains, and end the process at once
/// with exit code 128 + signal. Nothing needs to be undone, since the folder of a run is valid at every moment
/// (exporters/output_folder.h).
class InterruptNotice {
 public:
  InterruptNotice();
  ~InterruptNotice();
  InterruptNotice(const InterruptNotice&) = delete;
  InterruptNotice& operator=(const InterruptNotice&) = delete;
};

}  // namespace citykiln::commands
