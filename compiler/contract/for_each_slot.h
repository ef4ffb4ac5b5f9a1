// Threads may change when a thing is computed, never where it is put: each index fills its own slot, and slots are
// joined in order.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace citykiln {

/// Calls `work(i)` for i = 0 … count - 1 on at most `threads` threads (0: as many as the machine has). `work` must
/// write only to the i-th slot of what it fills. Blocks until all are done.
void for_each_index(std::size_t count, int threads, const std::function<void(std::size_t)>& work);

/// More than threads: while one that takes long is made, others go on behind it.
inline constexpr int kInFlightPerThread = 4;

/// Calls `make(i)` as for_each_index does, and `take(i)` for one index after another, each made: no more than
/// kInFlightPerThread a thread are begun and not yet taken. Ends after the first `take` that returns false.
void for_each_in_order(std::size_t count, int threads, const std::function<void(std::size_t)>& make,
                       const std::function<bool(std::size_t)>& take);

/// Calls both. With as many threads as the machine has (0), those that find nothing to do in the loops of `work` begin
/// with `aside`, and what is left of that is done when `work` is; else one after the other. Neither may need the other.
void run_concurrently(int threads, const std::function<void()>& work, const std::function<void()>& background);

/// The slots that `make(i)` filled, in order.
template <typename T, typename Make>
std::vector<T> for_each_slot(std::size_t count, int threads, Make make) {
  std::vector<T> slots(count);
  for_each_index(count, threads, [&](std::size_t i) { slots[i] = make(i); });
  return slots;
}

}  // namespace citykiln
