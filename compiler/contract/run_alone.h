// Runs a function on the calling thread alone.
#pragma once

#include <functional>

namespace citykiln {

/// Calls `work`. Parallel loops (for_each_slot.h) inside it run on this thread only, and this thread takes no part in
/// other loops until it returns. A thread that others wait for can therefore call it without being held up by their
/// work.
void run_alone(const std::function<void()>& work);

}  // namespace citykiln
