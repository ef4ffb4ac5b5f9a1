#include "compiler/contract/disjoint_sets.h"

#include <gtest/gtest.h>

namespace citykiln {
namespace {

TEST(DisjointSets, AreRepresentedByTheirLowestNumbers) {
  DisjointSets sets(6);
  sets.join(5, 3), sets.join(4, 2), sets.join(3, 4);
  EXPECT_EQ(sets.lowest(), (std::vector<std::uint32_t>{0, 1, 2, 2, 2, 2}));
}

TEST(DisjointSets, GrowByNumbersOfTheirOwn) {
  DisjointSets sets;
  sets.add(), sets.add(), sets.add();
  sets.join(2, 1);
  EXPECT_EQ(sets.size(), 3u);
  EXPECT_EQ(sets.find(0), 0u);
  EXPECT_EQ(sets.find(2), 1u);
}

}  // namespace
}  // namespace citykiln
