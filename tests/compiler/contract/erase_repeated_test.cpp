#include "compiler/contract/erase_repeated.h"

#include <gtest/gtest.h>

#include <utility>

namespace citykiln {
namespace {

using Pairs = std::vector<std::pair<int, char>>;

TEST(EraseRepeated, KeepsTheFirstOfEachRun) {
  Pairs all = {{1, 'a'}, {1, 'b'}, {2, 'c'}, {1, 'd'}, {1, 'e'}, {1, 'f'}};
  erase_repeated(all, &Pairs::value_type::first);
  EXPECT_EQ(all, (Pairs{{1, 'a'}, {2, 'c'}, {1, 'd'}}));
}

TEST(EraseRepeated, LeavesAnEmptyVectorUnchanged) {
  std::vector<int> none;
  erase_repeated(none, [](int i) { return i; });
  EXPECT_TRUE(none.empty());
}

}  // namespace
}  // namespace citykiln
