#include "compiler/contract/system/for_each_slot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <numeric>
#include <thread>

namespace citykiln {
namespace {

TEST(ForEachInOrder, TakesAllInOrderAfterMaking) {
  for (const int threads : {1, 2, 8}) {
    std::vector<int> made(500, 0);
    std::vector<std::size_t> taken;
    for_each_in_order(
        made.size(), threads, [&](std::size_t i) { made[i] = 1; },
        [&](std::size_t i) {
          EXPECT_EQ(made[i], 1);
          taken.push_back(i);
          return true;
        });
    std::vector<std::size_t> all(made.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    EXPECT_EQ(taken, all) << threads << " threads";
  }
}

TEST(ForEachInOrder, LimitsIndicesInFlight) {
  constexpr int kThreads = 3;
  std::atomic<int> waiting = 0, most = 0;
  for_each_in_order(
      200, kThreads,
      [&](std::size_t i) {
        const int now = ++waiting;
        for (int seen = most; seen < now && !most.compare_exchange_weak(seen, now);) {
        }
        // the others could run ahead
        if (i == 0) std::this_thread::sleep_for(std::chrono::milliseconds(300));
      },
      [&](std::size_t) {
        --waiting;
        return true;
      });
  EXPECT_LE(most, kInFlightPerThread * kThreads);
  EXPECT_GT(most, kThreads);
}

TEST(RunConcurrently, RunsBothOnce) {
  for (const int threads : {0, 1, 3}) {
    std::vector<int> work(300, 0), aside(300, 0);
    const auto fill = [&](std::vector<int>& slots) {
      return [&] { for_each_index(slots.size(), threads, [&](std::size_t i) { slots[i] += static_cast<int>(i); }); };
    };
    run_concurrently(threads, fill(work), fill(aside));
    std::vector<int> all(300);
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(work, all) << threads << " threads";
    EXPECT_EQ(aside, all) << threads << " threads";
  }
}

TEST(ForEachInOrder, EndsWhenTakeReturnsFalse) {
  std::size_t taken = 0;
  std::atomic<std::size_t> made = 0;
  for_each_in_order(
      1000, 2, [&](std::size_t) { ++made; }, [&](std::size_t i) { return ++taken, i < 10; });
  EXPECT_EQ(taken, 11u);
  EXPECT_LT(made, 20u);
}

}  // namespace
}  // namespace citykiln
