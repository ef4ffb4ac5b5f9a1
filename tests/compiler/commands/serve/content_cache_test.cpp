#include "compiler/commands/serve/content_cache.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <future>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace citykiln::commands {
namespace {

using Bytes = std::vector<std::byte>;
const auto kWanted = [] { return true; };
const auto kUnwanted = [] { return false; };

ContentCache::Make bytes_of_size(std::size_t size) {
  return [size]() -> Result<Bytes> { return Bytes(size); };
}

TEST(ContentCache, MakesAContentOnce) {
  ContentCache cache(100, 2);
  const SharedBytes first = cache.get("a", kWanted, bytes_of_size(10));
  ASSERT_TRUE(first);
  EXPECT_EQ(cache.get("a", kWanted, bytes_of_size(20)), first);
  EXPECT_EQ(cache.counters().made, 1u);
  EXPECT_EQ(cache.counters().found, 1u);
}

TEST(ContentCache, ForgetsWhatWasAskedForLongestAgo) {
  ContentCache cache(30, 1);
  for (const char* name : {"a", "b", "c", "a", "d"}) cache.get(name, kWanted, bytes_of_size(10));
  EXPECT_EQ(cache.counters().bytes, 30u);
  const auto made_before = cache.counters().made;
  for (const char* name : {"a", "c", "d"}) cache.get(name, kWanted, bytes_of_size(10));
  EXPECT_EQ(cache.counters().made, made_before);
  cache.get("b", kWanted, bytes_of_size(10));
  EXPECT_EQ(cache.counters().made, made_before + 1);
}

TEST(ContentCache, DoesNotKeepWhatIsLargerThanTheCache) {
  ContentCache cache(30, 1);
  cache.get("a", kWanted, bytes_of_size(10));
  EXPECT_EQ(cache.get("b", kWanted, bytes_of_size(31))->size(), 31u);
  EXPECT_EQ(cache.counters().bytes, 10u);
}

TEST(ContentCache, TriesAgainWhatFailed) {
  ContentCache cache(30, 1);
  EXPECT_FALSE(cache.get("a", kWanted, []() -> Result<Bytes> { return Error{"", "no"}; }));
  EXPECT_TRUE(cache.get("a", kWanted, bytes_of_size(1)));
  EXPECT_EQ(cache.counters().failed, 1u);
}

/// A content whose making goes on until it is let go.
struct Held {
  std::promise<void> begun, may_end;

  ContentCache::Make make() {
    return [this]() -> Result<Bytes> {
      begun.set_value();
      may_end.get_future().wait();
      return Bytes(1);
    };
  }
};

TEST(ContentCache, GivesUpWhatNobodyWaitsFor) {
  ContentCache cache(30, 1);
  Held held;
  std::thread first([&] { cache.get("a", kWanted, held.make()); });
  held.begun.get_future().wait();
  EXPECT_FALSE(cache.get("b", kUnwanted, bytes_of_size(1)));
  held.may_end.set_value();
  first.join();
  EXPECT_EQ(cache.counters().given_up, 1u);
  EXPECT_EQ(cache.counters().made, 1u);
}

TEST(ContentCache, RequestsForOneContentShareTheWork) {
  ContentCache cache(30, 4);
  Held held;
  std::thread first([&] { cache.get("a", kWanted, held.make()); });
  held.begun.get_future().wait();
  std::thread second([&] { EXPECT_TRUE(cache.get("a", kWanted, bytes_of_size(2))); });
  held.may_end.set_value();
  first.join(), second.join();
  EXPECT_EQ(cache.counters().made, 1u);
}

TEST(ContentCache, MakesInTheOrderOfRequests) {
  ContentCache cache(30, 1);
  Held held;
  std::vector<std::thread> threads;
  threads.emplace_back([&] { cache.get("first", kWanted, held.make()); });
  held.begun.get_future().wait();
  std::string order;
  std::vector<std::promise<void>> waits(3);
  // names against the order, each asked for when the one before waits
  for (std::size_t i = 0; i < waits.size(); ++i) {
    const char* name = std::array{"c", "b", "a"}[i];
    threads.emplace_back([&, name, i] {
      const auto is_wanted = [&waits, i, told = false]() mutable {
        if (!std::exchange(told, true)) waits[i].set_value();
        return true;
      };
      cache.get(name, is_wanted, [&, name]() -> Result<Bytes> {
        order += name;
        return Bytes(1);
      });
    });
    waits[i].get_future().wait();
  }
  held.may_end.set_value();
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(order, "cba");
}

TEST(ContentCache, MakesNoMoreAtOnceThanAsked) {
  ContentCache cache(1000, 2);
  std::atomic<int> now = 0, most = 0;
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i)
    threads.emplace_back([&, i] {
      cache.get(std::to_string(i), kWanted, [&]() -> Result<Bytes> {
        const int running = ++now;
        for (int seen = most; running > seen && !most.compare_exchange_weak(seen, running);) {
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        --now;
        return Bytes(1);
      });
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_LE(most, 2);
  EXPECT_EQ(cache.counters().made, 8u);
}

}  // namespace
}  // namespace citykiln::commands
