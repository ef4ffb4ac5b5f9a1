// One-time initialisation in which waiting threads help.
#pragma once

#include <functional>
#include <memory>

namespace citykiln {

/// Like std::once_flag, except that threads which arrive during the call do not sleep: they join the parallel loops
/// (for_each_slot.h) of `make` and continue when it has finished.
class Once {
 public:
  Once();
  ~Once();

  /// Calls `make` unless a call has finished before. `make` must not use the same Once.
  void call(const std::function<void()>& make);

 private:
  struct Flag;
  std::unique_ptr<Flag> flag_;
};

}  // namespace citykiln
