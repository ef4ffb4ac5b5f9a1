// Lets Ctrl-C end work early and keep the finished part.
#pragma once

#include <atomic>

namespace citykiln::commands {

/// During its lifetime the first SIGINT sets is_stopped(), instead of ending the process, and prints a line on stderr.
/// The second one ends the process. Afterwards SIGINT has the effect that it had before. Only one object may exist at a
/// time.
class StopOnInterrupt {
 public:
  StopOnInterrupt();
  ~StopOnInterrupt();
  StopOnInterrupt(const StopOnInterrupt&) = delete;
  StopOnInterrupt& operator=(const StopOnInterrupt&) = delete;

  const std::atomic<bool>& is_stopped() const;

 private:
  void (*previous_)(int);
};

}  // namespace citykiln::commands
