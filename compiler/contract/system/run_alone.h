// Runs a function on the calling thread alone.
#pragma once

#include <functional>

namespace citykiln {

/// Calls `work`. for_each_index() and for_each_slot() inside it run on this thread only, and this thread takes no part
/// in other loops until it returns. A thread that others wait for can therefore call it without being held up by their
/// work. for_each_in_order() starts its own threads inside it, too.
void run_alone(const std::function<void()>& work);

}  // namespace citykiln
