#include "compiler/parcels/strips.h"

#include <gtest/gtest.h>

#include "tests/compiler/parcels/made_land.h"

namespace citykiln::parcels {
namespace {

// Walks along a chain until it returns or ends.
std::vector<std::uint32_t> chain_from(const Strips& strips, std::uint32_t first) {
  std::vector<std::uint32_t> chain;
  for (std::uint32_t f = first; f != kNoIndex && chain.size() <= strips.frontages.size();
       f = strips.frontages[f].next) {
    if (!chain.empty() && f == first) return chain;
    chain.push_back(f);
  }
  return chain;
}

TEST(Strips, AChainRunsAroundADeadEnd) {
  const Strips strips = strips_of({street(1, {{0, 0}, {50, 0}})});
  EXPECT_EQ(strips.frontages.size(), 18u);  // two sides, two ends of eight edges
  EXPECT_EQ(chain_from(strips, 0).size(), 18u);
  for (const Frontage& f : strips.frontages) EXPECT_TRUE(f.turns_outward);
}

TEST(Strips, EdgesOfACornerMeet) {
  const Strips strips = strips_of({street(1, {{0, 0}, {50, 0}, {50, 50}})});
  const Frontage& before = strips.frontages[0];  // the left side of the first segment
  ASSERT_NE(before.next, kNoIndex);
  EXPECT_TRUE(before.is_corner);
  EXPECT_EQ(before.b, (Vec2{46, 4}));
  EXPECT_EQ(strips.frontages[before.next].a, before.b);
}

TEST(Strips, OutsideOfABendTheEdgesAreContinued) {
  const Strips strips = strips_of({street(1, {{0, 0}, {50, 0}, {90, 20}})});
  for (const Frontage& f : strips.frontages) EXPECT_TRUE(f.next == kNoIndex || f.b == strips.frontages[f.next].a);
}

TEST(Strips, EachBlockOfACrossingHasAChain) {
  const Strips strips =
      strips_of({street(1, {{0, 0}, {50, 0}}), street(2, {{0, 0}, {0, 50}}), street(3, {{0, 0}, {-50, 0}})});
  EXPECT_EQ(strips.frontages.size(), 30u);
  // all edges are about the same land, as nothing is closed
  EXPECT_EQ(chain_from(strips, 0).size(), 30u);
}

TEST(Strips, BarriersHaveNoFrontage) {
  const Strips strips = strips_of({street(1, {{0, 0}, {50, 0}}, LineKind::kBarrier)});
  EXPECT_TRUE(strips.frontages.empty());
  EXPECT_EQ(strips.pieces.size(), 17u);  // the segment and two round ends of eight
}

TEST(Strips, ANarrowStripHasTheLeastWidth) {
  Line line = street(1, {{0, 0}, {50, 0}});
  line.left_m = 0;
  EXPECT_EQ(strips_of({line}).frontages[0].a.y, kLeastStrip_m);
}

}  // namespace
}  // namespace citykiln::parcels
