#include "compiler/commands/stop_on_interrupt.h"

#include <unistd.h>

#include <csignal>
#include <string_view>

namespace citykiln::commands {
namespace {

std::atomic<bool> stopped = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may set it");

// only calls that are allowed in signal handlers
void stop(int) {
  stopped = true;
  std::signal(SIGINT, SIG_DFL);
  constexpr std::string_view kLine =
      "\r\x1b[Kcitykiln: interrupted; the picture so far is being written. Again to end at once\n";
  const ssize_t ignored = write(STDERR_FILENO, kLine.data(), kLine.size());
  static_cast<void>(ignored);
}

}  // namespace

StopOnInterrupt::StopOnInterrupt() {
  stopped = false;
  previous_ = std::signal(SIGINT, stop);
}

StopOnInterrupt::~StopOnInterrupt() { std::signal(SIGINT, previous_); }

const std::atomic<bool>& StopOnInterrupt::is_stopped() const { return stopped; }

}  // namespace citykiln::commands
