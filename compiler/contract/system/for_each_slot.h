// Parallel loops with deterministic results: each index writes its own slot, and the slots are combined in order.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace citykiln {

/// Calls `work(i)` for i = 0 … count - 1 on at most `threads` threads (0: all processors) and waits for all calls.
/// `work(i)` must write to slot i only.
void for_each_index(std::size_t count, int threads, const std::function<void(std::size_t)>& work);

/// The number of indices in progress per thread. It is more than 1 so that threads continue while one index takes long.
inline constexpr int kInFlightPerThread = 4;

/// Calls `make(i)` in parallel. Calls `take(i)` in order, one at a time, each after make(i) has finished. At most
/// kInFlightPerThread indices per thread are made and not yet taken. Ends after the first `take` that returns false.
void for_each_in_order(std::size_t count, int threads, const std::function<void(std::size_t)>& make,
                       const std::function<bool(std::size_t)>& take);

/// Calls both functions, which must be independent of each other. With threads = 0, threads that have no work in the
/// parallel loops of `work` begin with `background`, and the rest of `background` runs after `work`. With any other
/// number of threads `background` runs after `work`.
void run_concurrently(int threads, const std::function<void()>& work, const std::function<void()>& background);

/// Returns make(0) … make(count - 1), computed in parallel.
template <typename T, typename Make>
std::vector<T> for_each_slot(std::size_t count, int threads, Make make) {
  std::vector<T> slots(count);
  for_each_index(count, threads, [&](std::size_t i) { slots[i] = make(i); });
  return slots;
}

}  // namespace citykiln
