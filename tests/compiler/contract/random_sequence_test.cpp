#include "compiler/contract/random_sequence.h"

#include <gtest/gtest.h>

namespace citykiln {
namespace {

// kat_vectors of the authors' Random123 distribution, philox4x32, 10 rounds
TEST(RandomSequence, PhiloxGivesTheAuthorsKnownAnswers) {
  using Four = std::array<std::uint32_t, 4>;
  EXPECT_EQ(philox4x32_10({0, 0, 0, 0}, {0, 0}), (Four{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(philox4x32_10({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, {0xffffffff, 0xffffffff}),
            (Four{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox4x32_10({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (Four{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(RandomSequence, NumbersAreEvenlySpread) {
  const RandomSequence draw(7, stable_id(ObjectId{{OsmType::kWay, 42}, 0}), "test");
  std::array<int, 10> counts{};
  for (std::uint32_t i = 0; i < 100000; ++i) ++counts[static_cast<std::size_t>(draw.unit(i) * 10)];
  // chi squared with 9 degrees of freedom: 27.9 is passed once in a thousand
  double chi2 = 0;
  for (const int count : counts) chi2 += (count - 10000.0) * (count - 10000.0) / 10000.0;
  EXPECT_LT(chi2, 27.9);
}

TEST(RandomSequence, ObjectsPurposesAndSeedsAreIndependent) {
  const StableId a = stable_id(ObjectId{{OsmType::kWay, 1}, 0}), b = stable_id(ObjectId{{OsmType::kNode, 1}, 0});
  EXPECT_NE(RandomSequence(1, a, "x").unit(0), RandomSequence(1, b, "x").unit(0));
  EXPECT_NE(RandomSequence(1, a, "x").unit(0), RandomSequence(1, a, "y").unit(0));
  EXPECT_NE(RandomSequence(1, a, "x").unit(0), RandomSequence(2, a, "x").unit(0));
  EXPECT_EQ(RandomSequence(1, a, "x").unit(5), RandomSequence(1, a, "x").unit(5));
}

}  // namespace
}  // namespace citykiln
