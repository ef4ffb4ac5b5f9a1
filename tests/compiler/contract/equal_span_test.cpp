#include "compiler/contract/equal_span.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace citykiln {
namespace {

TEST(EqualSpan, HoldsTheElementsOfTheKey) {
  const std::vector<std::pair<int, char>> sorted = {{1, 'a'}, {2, 'b'}, {2, 'c'}, {5, 'd'}};
  const auto twos = equal_span(sorted, 2, &std::pair<int, char>::first);
  ASSERT_EQ(twos.size(), 2u);
  EXPECT_EQ(twos.data(), sorted.data() + 1);
  EXPECT_TRUE(equal_span(sorted, 3, &std::pair<int, char>::first).empty());
  EXPECT_EQ(equal_span(std::vector{4, 4, 4}, 4).size(), 3u);
}

}  // namespace
}  // namespace citykiln
