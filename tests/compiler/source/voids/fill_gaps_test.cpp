#include "compiler/source/voids/fill_gaps.h"

#include <gtest/gtest.h>

namespace citykiln::source {
namespace {

TEST(FillUncovered, TakesTheNearestHeightOfTheRowElseOfTheNearestRow) {
  std::vector<std::int32_t> heights = {0, 0, 0, 0,   // unknown
                                       5, 0, 0, 8,   // known at both ends
                                       0, 0, 0, 0,   // unknown, as near to the row before as to the one after
                                       0, 7, 0, 0};  // known at one place
  std::vector<bool> known(heights.size(), false);
  known[4] = known[7] = known[13] = true;
  EXPECT_EQ(fill_uncovered(heights, known, 4), 13u);
  EXPECT_EQ(heights, (std::vector<std::int32_t>{5, 5, 8, 8, 5, 5, 8, 8, 5, 5, 8, 8, 7, 7, 7, 7}));
}

TEST(FillUncovered, PrefersTheHeightBeforeOfTwoEquallyNear) {
  std::vector<std::int32_t> heights = {1, 0, 3};
  EXPECT_EQ(fill_uncovered(heights, {true, false, true}, 3), 1u);
  EXPECT_EQ(heights, (std::vector<std::int32_t>{1, 1, 3}));
}

TEST(FillUncovered, ChangesNothingWithoutAnyKnownHeight) {
  std::vector<std::int32_t> heights(6, 4);
  EXPECT_EQ(fill_uncovered(heights, std::vector<bool>(6, false), 3), 6u);
  EXPECT_EQ(heights, std::vector<std::int32_t>(6, 4));
}

}  // namespace
}  // namespace citykiln::source
