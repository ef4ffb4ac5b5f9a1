#include <gtest/gtest.h>

#include "tests/compiler/map/map_text.h"

namespace citykiln::map {
namespace {

TEST(LocateLandforms, LinesThatShapeTheLandHaveAKindAHeightAndATop) {
  const Features features = features_of(R"(
    w1 0:0 90:0 barrier=retaining_wall height=4
    w2 0:5 90:5 natural=cliff
    w3 0:9 90:9 man_made=dyke height=3
    w4 0:20 90:20 waterway=dam width=6
    w5 0:30 90:30 man_made=pier height=9
    w6 0:40 90:40 man_made=groyne
    w7 0:50 90:50 man_made=embankment)");
  ASSERT_EQ(features.landforms.size(), 7u);
  const auto& forms = features.landforms;
  EXPECT_EQ(forms[0].kind, LandformKind::kWall);
  EXPECT_TRUE(forms[0].has_height && forms[0].height_m == 4);
  EXPECT_EQ(forms[1].kind, LandformKind::kStep);
  EXPECT_FALSE(forms[1].has_height);
  EXPECT_EQ(forms[2].kind, LandformKind::kRidge);
  EXPECT_EQ(forms[2].height_m, 3);
  EXPECT_EQ(forms[3].kind, LandformKind::kDam);
  EXPECT_EQ(forms[3].width_m, 6);
  EXPECT_EQ(forms[4].kind, LandformKind::kDeck);
  EXPECT_EQ(forms[4].height_m, 1.25) << "a tagged height of a pier is not that above water";
  EXPECT_EQ(forms[5].surface, LandCoverClass::kBreakwater);
  EXPECT_EQ(forms[6].kind, LandformKind::kStep);
}

TEST(LocateLandforms, AWallThatHoldsTheGroundIsARetainingWall) {
  const Features features = features_of(R"(
    w1 0:0 90:0 barrier=wall wall=retaining_wall height=4
    w2 0:9 90:9 barrier=wall wall=dry_stone)");
  ASSERT_EQ(features.landforms.size(), 1u);
  EXPECT_EQ(features.landforms[0].kind, LandformKind::kWall);
  EXPECT_EQ(features.landforms[0].height_m, 4);
  ASSERT_EQ(features.barriers.size(), 2u);
  EXPECT_EQ(features.barriers[0].kind, BarrierKind::kRetainingWall);
  EXPECT_EQ(features.barriers[1].kind, BarrierKind::kWall);
}

TEST(LocateLandforms, BarriersOffTheGroundAreDropped) {
  Report report;
  const Features features = features_of(R"(
    w1 0:0 90:0 barrier=fence layer=1
    w2 0:9 90:9 barrier=wall layer=-1
    w3 0:19 90:19 barrier=fence level=2
    w4 0:29 90:29 barrier=fence layer=0)",
                                        report);
  EXPECT_EQ(features.barriers.size(), 1u);
  EXPECT_EQ(report.counts()[Code::kAboveGround], 2u);
  EXPECT_EQ(report.counts()[Code::kUnderground], 1u);
  EXPECT_TRUE(report.balances());
}

TEST(LocateLandforms, AClosedPierThatIsNoAreaIsALine) {
  EXPECT_EQ(features_of("w1 0:0 90:0 90:30 0:30 0:0 man_made=pier area=no").landforms.size(), 1u);
}

TEST(LocateLandforms, PiersThatAreAreasOrBridgesAreNoLines) {
  const Features features = features_of(R"(
    w1 0:0 90:0 90:30 0:30 0:0 man_made=pier
    w2 0:50 90:50 man_made=pier bridge=yes highway=service
    w3 0:60 90:60 man_made=pier highway=footway)");
  ASSERT_EQ(features.landforms.size(), 1u);
  EXPECT_EQ(features.landforms[0].id.osm.id, 3);
}

TEST(LocateLandforms, DamsAndWeirsAreNoWaterwaysOfAnUnknownKind) {
  Report report;
  const Features features = features_of(R"(
    w1 0:0 90:0 waterway=weir
    w2 0:5 90:5 waterway=dam)",
                                        report);
  EXPECT_TRUE(features.waterways.empty());
  EXPECT_EQ(features.landforms.size(), 2u);
  EXPECT_EQ(report.account("map", "waterway").in, 0u);
}

}  // namespace
}  // namespace citykiln::map
