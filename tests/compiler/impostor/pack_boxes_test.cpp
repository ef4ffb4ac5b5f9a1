#include "compiler/impostor/pack_boxes.h"

#include <gtest/gtest.h>

#include <bit>
#include <random>
#include <set>

namespace citykiln::impostor {
namespace {

TEST(PackBoxes, BoxesDoNotOverlapAndLieInTheImage) {
  std::mt19937 dice(7);
  for (int round = 0; round < 50; ++round) {
    std::vector<BoxSize> boxes;
    const auto side = [&dice] { return static_cast<std::uint32_t>(dice() % 30 + 1); };
    for (unsigned i = dice() % 40 + 1; i > 0; --i) boxes.push_back({.columns = side(), .rows = side()});
    const PackedBoxes packed = pack_boxes(boxes);
    EXPECT_TRUE(std::has_single_bit(packed.columns) && std::has_single_bit(packed.rows));
    std::set<std::pair<std::uint32_t, std::uint32_t>> taken;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      EXPECT_LE(packed.places[i].column + boxes[i].columns, packed.columns);
      EXPECT_LE(packed.places[i].row + boxes[i].rows, packed.rows);
      for (std::uint32_t y = 0; y < boxes[i].rows; ++y)
        for (std::uint32_t x = 0; x < boxes[i].columns; ++x)
          EXPECT_TRUE(taken.emplace(packed.places[i].column + x, packed.places[i].row + y).second);
    }
  }
}

TEST(PackBoxes, EqualSquaresFillASquare) {
  const PackedBoxes packed = pack_boxes(std::vector<BoxSize>(16, BoxSize{64, 64}));
  EXPECT_EQ(packed.columns, 256u);
  EXPECT_EQ(packed.rows, 256u);
}

TEST(PackBoxes, NoBoxesNeedNoTexels) { EXPECT_EQ(pack_boxes({}).columns, 0u); }

}  // namespace
}  // namespace citykiln::impostor
