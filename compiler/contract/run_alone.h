// Runs work on the calling thread alone.
#pragma once

#include <functional>

namespace citykiln {

/// Calls `work`. Parallel loops (for_each_slot.h) inside it run on this thread, and while it lasts this thread takes no
/// part in loops outside of it: it may be called by a thread on which others wait.
void run_alone(const std::function<void()>& work);

}  // namespace citykiln
