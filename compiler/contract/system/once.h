// One-time initialisation in which waiting threads help.
#pragma once

#include <functional>
#include <memory>

namespace citykiln {

/// Like std::once_flag, except that a thread which arrives during the call does not sleep: it joins the parallel loops
/// (for_each_slot.h) of `make` and returns when `make` has finished.
class Once {
 public:
  Once();
  ~Once();

  /// Calls `make` on the first call. Calls during it help and wait; later ones return at once. `make` must not use the
  /// same Once.
  void call(const std::function<void()>& make);

 private:
  struct Flag;
  std::unique_ptr<Flag> flag_;
};

}  // namespace citykiln
