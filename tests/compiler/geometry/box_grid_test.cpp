#include "compiler/geometry/box_grid.h"

#include <gtest/gtest.h>

#include "compiler/contract/random_sequence.h"

namespace citykiln {
namespace {

std::vector<Box2> random_boxes(std::uint64_t seed, int count) {
  const RandomSequence draw(seed, StableId{31}, "boxes");
  std::vector<Box2> boxes;
  for (int b = 0; b < count; ++b) {
    const auto i = static_cast<std::uint32_t>(4 * b);
    const Vec2 min{draw.between(-300, 300, i), draw.between(-200, 200, i + 1)};
    boxes.push_back({min, min + Vec2{draw.between(0, 60, i + 2), draw.between(0, 60, i + 3)}});
  }
  return boxes;
}

TEST(BoxGrid, IsAnyAgreesWithBoxesAbout) {
  int found = 0, missed = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const BoxGrid grid = grid_of(random_boxes(seed, static_cast<int>(seed)), 16);
    for (const Box2& box : random_boxes(seed + 100, 200)) {
      const bool is_any = is_any_about(grid, box);
      EXPECT_EQ(is_any, !boxes_about(grid, box).empty());
      ++(is_any ? found : missed);
    }
  }
  EXPECT_GT(found, 100);
  EXPECT_GT(missed, 100);
}

// Boxes far away must not change what is found here: regions of a plan have none of them.
TEST(BoxGrid, FindsTheSameWhateverElseItHolds) {
  std::vector<Box2> boxes = random_boxes(3, 40);
  const BoxGrid alone = grid_of(boxes, 16);
  boxes.push_back({{-5003.25, -4001.5}, {-5000, -4000}});
  boxes.push_back({{6000, 7000}, {6001.75, 7003}});
  const BoxGrid among = grid_of(boxes, 16);
  const RandomSequence draw(3, StableId{33}, "places");
  int found = 0;
  for (std::uint32_t i = 0; i < 2000; ++i) {
    const Vec2 p{draw.between(-400, 460, 2 * i), draw.between(-300, 360, 2 * i + 1)};
    const auto here = boxes_about(alone, p);
    EXPECT_TRUE(std::ranges::equal(here, boxes_about(among, p))) << p.x << " " << p.y;
    const Box2 box{p, p + Vec2{24, 24}};
    EXPECT_EQ(boxes_about(alone, box), boxes_about(among, box));
    found += here.empty() ? 0 : 1;
  }
  EXPECT_GT(found, 100);
}

// A box is left out only at places in the buckets where it is excluded.
TEST(BoxGrid, FindsAllBoxesThatAreNotExcluded) {
  const std::vector<Box2> boxes = random_boxes(1, 60);
  const auto is_odd_column = [](const Box2& bucket) { return std::fmod(std::floor(bucket.centre().x / 8), 2) != 0; };
  const BoxGrid whole = grid_of(boxes, 8);
  const BoxGrid some = grid_of(boxes, 8, [&](std::uint32_t, const Box2& bucket) { return is_odd_column(bucket); });
  const RandomSequence draw(1, StableId{32}, "places");
  int found = 0;
  for (std::uint32_t i = 0; i < 2000; ++i) {
    const Vec2 p{draw.between(-300, 360, 2 * i), draw.between(-200, 260, 2 * i + 1)};
    const auto all = boxes_about(whole, p), left = boxes_about(some, p);
    if (all.empty()) continue;
    EXPECT_TRUE(left.empty() || std::ranges::equal(all, left));
    found += left.empty() ? 0 : 1;
  }
  EXPECT_GT(found, 100);
}

}  // namespace
}  // namespace citykiln
