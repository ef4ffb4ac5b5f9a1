// What several threads need and one of them makes, while the others lend a hand.
#pragma once

#include <functional>
#include <memory>

namespace citykiln {

/// As std::once_flag, but whoever comes while it is being made does not sleep: it joins the loops (for_each_slot.h)
/// that `make` runs, and goes on when all is made.
class Once {
 public:
  Once();
  ~Once();

  /// Calls `make` unless that has been done. `make` must not come back to the same Once.
  void call(const std::function<void()>& make);

 private:
  struct Flag;
  std::unique_ptr<Flag> flag_;
};

}  // namespace citykiln
