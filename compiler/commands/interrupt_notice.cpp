#include "compiler/commands/interrupt_notice.h"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <csignal>

namespace citykiln::commands {
namespace {

/// The line of the innermost notice.
std::atomic<const std::string*> noticed = nullptr;
static_assert(std::atomic<const std::string*>::is_always_lock_free, "a signal handler reads it");

// only calls that are allowed in signal handlers
void end_with_notice(int signal) {
  constexpr std::string_view kBar = "\r\x1b[K";
  ssize_t ignored = isatty(STDERR_FILENO) != 0 ? write(STDERR_FILENO, kBar.data(), kBar.size()) : 0;
  if (const std::string* line = noticed) ignored += write(STDERR_FILENO, line->data(), line->size());
  static_cast<void>(ignored);
  _exit(128 + signal);
}

}  // namespace

InterruptNotice::InterruptNotice(std::string_view text)
    : line_(fmt::format("citykiln: interrupted; {}\n", text)), outer_(noticed.exchange(&line_)) {
  if (outer_ != nullptr) return;
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, end_with_notice);
}

InterruptNotice::~InterruptNotice() {
  if (outer_ == nullptr)
    for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, SIG_DFL);
  noticed = outer_;
}

}  // namespace citykiln::commands
