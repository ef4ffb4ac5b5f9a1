#include "compiler/commands/interrupt_notice.h"

#include <unistd.h>

#include <csignal>
#include <string_view>

namespace citykiln::commands {
namespace {

// only calls that are allowed in signal handlers
void end_with_notice(int signal) {
  constexpr std::string_view kBar = "\r\x1b[K";
  constexpr std::string_view kLine =
      "citykiln: interrupted; the output folder holds the earlier run, if there was one, and the same command goes on "
      "with the tiles baked so far\n";
  ssize_t ignored = isatty(STDERR_FILENO) != 0 ? write(STDERR_FILENO, kBar.data(), kBar.size()) : 0;
  ignored += write(STDERR_FILENO, kLine.data(), kLine.size());
  static_cast<void>(ignored);
  _exit(128 + signal);
}

}  // namespace

InterruptNotice::InterruptNotice() {
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, end_with_notice);
}

InterruptNotice::~InterruptNotice() {
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, SIG_DFL);
}

}  // namespace citykiln::commands
