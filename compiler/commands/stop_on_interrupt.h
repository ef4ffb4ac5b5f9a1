// Ctrl-C that ends work early and keeps what is done.
#pragma once

#include <atomic>

namespace citykiln::commands {

/// While it lives, the first SIGINT sets is_stopped() instead of ending the process, and prints a line on stderr; the
/// second one ends the process. One at a time.
class StopOnInterrupt {
 public:
  StopOnInterrupt();
  ~StopOnInterrupt();
  StopOnInterrupt(const StopOnInterrupt&) = delete;
  StopOnInterrupt& operator=(const StopOnInterrupt&) = delete;

  const std::atomic<bool>& is_stopped() const;
};

}  // namespace citykiln::commands
