#include "compiler/parcels/rights_of_way.h"

#include <gtest/gtest.h>

#include "tests/compiler/parcels/made_land.h"

namespace citykiln::parcels {
namespace {

// Walks along a chain until it returns or ends.
std::vector<std::uint32_t> chain_from(const RightsOfWay& ways, std::uint32_t first) {
  std::vector<std::uint32_t> chain;
  for (std::uint32_t f = first; f != kNoIndex && chain.size() <= ways.street_edges.size();
       f = ways.street_edges[f].next) {
    if (!chain.empty() && f == first) return chain;
    chain.push_back(f);
  }
  return chain;
}

TEST(RightsOfWay, AChainRunsAroundADeadEnd) {
  const RightsOfWay ways = rights_of_way_of({street(1, {{0, 0}, {50, 0}})});
  EXPECT_EQ(ways.street_edges.size(), 18u);  // two sides, two ends of eight edges
  EXPECT_EQ(chain_from(ways, 0).size(), 18u);
  for (const RightOfWayEdge& f : ways.street_edges) EXPECT_TRUE(f.turns_outward);
}

TEST(RightsOfWay, EdgesOfACornerMeet) {
  const RightsOfWay ways = rights_of_way_of({street(1, {{0, 0}, {50, 0}, {50, 50}})});
  const RightOfWayEdge& before = ways.street_edges[0];  // the left side of the first segment
  ASSERT_NE(before.next, kNoIndex);
  EXPECT_TRUE(before.is_corner);
  EXPECT_EQ(before.b, (Vec2{46, 4}));
  EXPECT_EQ(ways.street_edges[before.next].a, before.b);
}

TEST(RightsOfWay, OutsideOfABendTheEdgesAreContinued) {
  const RightsOfWay ways = rights_of_way_of({street(1, {{0, 0}, {50, 0}, {90, 20}})});
  for (const RightOfWayEdge& f : ways.street_edges)
    EXPECT_TRUE(f.next == kNoIndex || f.b == ways.street_edges[f.next].a);
}

TEST(RightsOfWay, EachBlockOfACrossingHasAChain) {
  const RightsOfWay ways =
      rights_of_way_of({street(1, {{0, 0}, {50, 0}}), street(2, {{0, 0}, {0, 50}}), street(3, {{0, 0}, {-50, 0}})});
  EXPECT_EQ(ways.street_edges.size(), 30u);
  // all edges are about the same land, as nothing is closed
  EXPECT_EQ(chain_from(ways, 0).size(), 30u);
}

TEST(RightsOfWay, BarriersHaveNoFrontage) {
  const RightsOfWay ways = rights_of_way_of({street(1, {{0, 0}, {50, 0}}, LineKind::kBarrier)});
  EXPECT_TRUE(ways.street_edges.empty());
  EXPECT_EQ(ways.pieces.size(), 17u);  // the segment and two round ends of eight
}

TEST(RightsOfWay, ANarrowStripHasTheLeastWidth) {
  Line line = street(1, {{0, 0}, {50, 0}});
  line.left_m = 0;
  EXPECT_EQ(rights_of_way_of({line}).street_edges[0].a.y, kLeastRightOfWay_m);
}

}  // namespace
}  // namespace citykiln::parcels
