#include "compiler/map/buildings/part_outlines.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace citykiln::map {
namespace {

Footprint square(std::int64_t id, double x, double y, double size, bool is_part = false) {
  Footprint f;
  f.id = {{OsmType::kWay, id}, 0};
  f.polygon.outer = {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
  f.is_part = is_part;
  return f;
}

using Outlines = std::vector<std::uint32_t>;

TEST(PartOutlines, AreTheSmallestThatContainThePart) {
  const std::vector<Footprint> footprints = {square(1, 0, 0, 60), square(2, 40, 0, 10), square(3, 42, 2, 4, true),
                                             square(4, 2, 2, 4, true)};
  EXPECT_EQ(part_outlines(footprints), (Outlines{kNoOutline, kNoOutline, 1, 0}));
}

TEST(PartOutlines, OfEqualOnesAreThatOfTheLowestId) {
  EXPECT_EQ(part_outlines(std::vector{square(7, 0, 0, 9), square(2, 0, 0, 9), square(8, 1, 1, 3, true)}),
            (Outlines{kNoOutline, kNoOutline, 1}));
}

TEST(PartOutlines, AreNoneForPartsOutsideOfAll) {
  EXPECT_EQ(part_outlines(std::vector{square(1, 0, 0, 9), square(2, 20, 0, 9, true)}),
            (Outlines{kNoOutline, kNoOutline}));
  EXPECT_TRUE(part_outlines({}).empty());
}

// The centre of its box, and the middle of most of its edges, lie outside of the part.
TEST(PartOutlines, AreFoundFromInsideOfABentPart) {
  Footprint bent = square(3, 0, 0, 1, true);
  bent.polygon.outer = {{0, 0}, {10, 0}, {10, 1}, {1, 1}, {1, 10}, {0, 10}};
  const std::vector<Footprint> footprints = {square(1, 0, 0, 10), square(2, 2, 2, 7), bent};
  EXPECT_EQ(part_outlines(footprints)[2], 0u);
}

TEST(PartOutlines, DoNotDependOnTheOrder) {
  std::vector<Footprint> footprints;
  for (int i = 0; i < 40; ++i)
    footprints.push_back(square(i + 1, (i % 8) * 10, (i / 8) * 10, i % 3 ? 25 : 9, i % 3 == 0));
  const auto ids = [](const std::vector<Footprint>& all) {
    std::vector<std::pair<ObjectId, ObjectId>> ids;
    const Outlines outlines = part_outlines(all);
    for (std::size_t i = 0; i < all.size(); ++i)
      if (outlines[i] != kNoOutline) ids.emplace_back(all[i].id, all[outlines[i]].id);
    std::ranges::sort(ids);
    return ids;
  };
  const auto one = ids(footprints);
  EXPECT_GT(one.size(), 5u);
  std::ranges::reverse(footprints);
  EXPECT_EQ(ids(footprints), one);
}

}  // namespace
}  // namespace citykiln::map
