#include "compiler/contract/system/for_each_slot.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <atomic>
#include <cassert>

namespace citykiln {

namespace {

// A nested loop uses the threads of the outer loop, so that a thread that finishes its part of one takes work of the
// other.
bool fits_current_arena(int threads) { return threads <= 0 || threads >= tbb::this_task_arena::max_concurrency(); }

}  // namespace

void for_each_index(std::size_t count, int threads, const std::function<void(std::size_t)>& work) {
  assert(threads >= 0);
  if (fits_current_arena(threads)) return tbb::parallel_for(std::size_t{0}, count, work);
  tbb::task_arena arena(threads);
  arena.execute([&] { tbb::parallel_for(std::size_t{0}, count, work); });
}

void for_each_in_order(std::size_t count, int threads, const std::function<void(std::size_t)>& make,
                       const std::function<bool(std::size_t)>& take) {
  assert(threads >= 0);
  tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
  std::size_t begun = 0;
  std::atomic<bool> goes_on = true;
  const auto next = [&](tbb::flow_control& control) {
    if (begun == count || !goes_on) control.stop();
    return begun++;
  };
  const auto made = [&](std::size_t i) {
    make(i);
    return i;
  };
  const auto taken = [&](std::size_t i) {
    if (goes_on) goes_on = take(i);
  };
  using tbb::filter_mode;
  arena.execute([&] {
    tbb::parallel_pipeline(static_cast<std::size_t>(kInFlightPerThread * arena.max_concurrency()),
                           tbb::make_filter<void, std::size_t>(filter_mode::serial_in_order, next) &
                               tbb::make_filter<std::size_t, std::size_t>(filter_mode::parallel, made) &
                               tbb::make_filter<std::size_t, void>(filter_mode::serial_in_order, taken));
  });
}

void run_concurrently(int threads, const std::function<void()>& work, const std::function<void()>& background) {
  assert(threads >= 0);
  if (threads > 0) return work(), background();
  tbb::task_arena idle(tbb::task_arena::automatic, 1, tbb::task_arena::priority::low);
  tbb::task_group group;
  idle.enqueue(group.defer(background));
  work();
  idle.execute([&] { group.wait(); });
}

}  // namespace citykiln
