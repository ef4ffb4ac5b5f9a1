#include "compiler/contract/system/once.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "compiler/contract/system/for_each_slot.h"

namespace citykiln {
namespace {

// Waits until so many have come, or half a minute.
bool meets(std::atomic<int>& here, int all) {
  ++here;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  while (here < all && std::chrono::steady_clock::now() < end) std::this_thread::yield();
  return here >= all;
}

TEST(Once, CallsOnceFromAnyThread) {
  for (const int threads : {1, 2, 8}) {
    Once once;
    std::atomic<int> made = 0, calls = 0;
    for_each_index(100, threads, [&](std::size_t) {
      once.call([&] { ++made; });
      EXPECT_EQ(made, 1);
      ++calls;
    });
    EXPECT_EQ(calls, 100);
  }
}

TEST(Once, WaitingThreadsHelp) {
  if (std::thread::hardware_concurrency() < 2) GTEST_SKIP() << "one processor";
  Once once;
  std::atomic<int> asking = 0, helping = 0;
  for_each_index(2, 2, [&](std::size_t) {
    meets(asking, 2);
    // each of both waits for the other: were one asleep, none would come
    once.call([&] { for_each_index(2, 2, [&](std::size_t) { EXPECT_TRUE(meets(helping, 2)); }); });
  });
}

}  // namespace
}  // namespace citykiln
