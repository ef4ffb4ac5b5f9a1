#include "compiler/whole_map.h"

#include <gtest/gtest.h>

namespace citykiln {
namespace {

template <typename Feature>
bool is_empty_with(std::vector<Feature> map::Features::*list) {
  map::Features features;
  (features.*list).emplace_back();
  return is_empty(features);
}

TEST(IsEmpty, IsFalseForEachKindOfFeature) {
  EXPECT_TRUE(is_empty({}));
  EXPECT_FALSE(is_empty_with(&map::Features::tracks));
  EXPECT_FALSE(is_empty_with(&map::Features::footprints));
  EXPECT_FALSE(is_empty_with(&map::Features::areas));
  EXPECT_FALSE(is_empty_with(&map::Features::sports_areas));
  EXPECT_FALSE(is_empty_with(&map::Features::waterways));
  EXPECT_FALSE(is_empty_with(&map::Features::barriers));
  EXPECT_FALSE(is_empty_with(&map::Features::landforms));
  EXPECT_FALSE(is_empty_with(&map::Features::points));
  EXPECT_FALSE(is_empty_with(&map::Features::things));
  EXPECT_FALSE(is_empty_with(&map::Features::tree_rows));
  EXPECT_FALSE(is_empty_with(&map::Features::power_lines));
}

}  // namespace
}  // namespace citykiln
