// Parallel loops with deterministic results: each index writes its own slot, and slots are combined in order.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace citykiln {

/// Calls `work(i)` for i = 0 … count - 1 on at most `threads` threads (0: all processors) and waits for all. `work`
/// must write to its own slot only.
void for_each_index(std::size_t count, int threads, const std::function<void(std::size_t)>& work);

/// Indices that may be in progress for each thread: more than one, so that others continue while one takes long.
inline constexpr int kInFlightPerThread = 4;

/// Calls `make(i)` in parallel and `take(i)` in order, one at a time, after make(i) has finished. At most
/// kInFlightPerThread indices for each thread are made and not yet taken. Ends after the first `take` that returns
/// false.
void for_each_in_order(std::size_t count, int threads, const std::function<void(std::size_t)>& make,
                       const std::function<bool(std::size_t)>& take);

/// Calls both functions, which must be independent of each other. With threads = 0, threads that are idle in the loops
/// of `work` start `background`, and its rest runs after `work`; with any other number `background` runs after `work`.
void run_concurrently(int threads, const std::function<void()>& work, const std::function<void()>& background);

/// Returns make(0) … make(count - 1), computed in parallel.
template <typename T, typename Make>
std::vector<T> for_each_slot(std::size_t count, int threads, Make make) {
  std::vector<T> slots(count);
  for_each_index(count, threads, [&](std::size_t i) { slots[i] = make(i); });
  return slots;
}

}  // namespace citykiln
