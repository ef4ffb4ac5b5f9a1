#include <gtest/gtest.h>

#include "tests/compiler/map/map_text.h"

namespace citykiln::map {
namespace {

TEST(LocateLines, WaterwaysTakeTheirWidthFromTagsElseTheirKind) {
  const Features features = features_of(R"(
    w1 0:0 90:0 waterway=river
    w2 0:5 90:5 waterway=river width=31
    w3 0:9 90:9 waterway=stream tunnel=culvert layer=-1
    w4 0:20 90:20 waterway=ditch width=huge
    w5 0:30 90:30 waterway=dam)");
  ASSERT_EQ(features.waterways.size(), 4u);
  EXPECT_EQ(features.waterways[0].width_m, 12);
  EXPECT_EQ(features.waterways[1].width_m, 31);
  EXPECT_EQ(features.waterways[2].passage, Passage::kTunnel);
  EXPECT_EQ(features.waterways[2].layer, -1);
  EXPECT_EQ(features.waterways[3].width_m, 1.25);
}

TEST(LocateLines, BarriersTakeTheirHeightFromTagsElseTheirKind) {
  const Features features = features_of(R"(
    w1 0:0 90:0 barrier=wall
    w2 0:5 90:5 barrier=fence height=2~m
    w3 0:9 90:9 barrier=hedge
    w4 0:12 90:12 barrier=retaining_wall
    w5 0:20 90:20 barrier=kerb)");
  ASSERT_EQ(features.barriers.size(), 5u);
  EXPECT_EQ(features.barriers[0].kind, BarrierKind::kWall);
  EXPECT_EQ(features.barriers[1].height_m, 2);
  EXPECT_EQ(features.barriers[2].kind, BarrierKind::kHedge);
  EXPECT_EQ(features.barriers[3].kind, BarrierKind::kRetainingWall);
  EXPECT_EQ(features.barriers[4].kind, BarrierKind::kKerb);
  for (const Barrier& barrier : features.barriers) EXPECT_TRUE(barrier.height_m > 0 && barrier.width_m > 0);
}

TEST(LocateLines, PointsAreReadWhereTheRegionIs) {
  Report report;
  const Features features = features_of(R"(
    n1 3:4 natural=tree height=11 leaf_type=needleleaved
    n2 5:4 highway=street_lamp
    n3 6:4 amenity=cafe
    n4 9000:4 natural=tree
    n5 7:4 name=nothing
    n6 8:4 natural=tree height=-5)",
                                        report);
  ASSERT_EQ(features.points.size(), 4u);
  EXPECT_EQ(features.points[0].height_m, 11);
  EXPECT_EQ(features.points[0].plant_tags.leaves, LeafType::kNeedle);
  EXPECT_EQ(features.points[1].kind, PointKind::kStreetLamp);
  EXPECT_EQ(features.points[3].height_m, 0);
  EXPECT_EQ(report.account("map", "point").dropped.at(Code::kOutsideBounds), 1u);
  EXPECT_EQ(report.counts()[Code::kBadTagValue], 1u);
  EXPECT_TRUE(report.balances());
}

TEST(LocateLines, LampsHaveTheLightThatIsTagged) {
  Report report;
  const Features features = features_of(R"(
    n1 3:4 highway=street_lamp lamp_type=high_pressure_sodium lamp_mount=bent_mast light:count=2 light:height=7~m
    n2 5:4 highway=street_lamp light:method=gas light:colour=2700~K light:lumen=600~lm
    n3 6:4 highway=street_lamp light:colour=orange lamp_type=unheard_of height=5 light:height=4
    n4 7:4 highway=street_lamp light:count=900 light:colour=9~K light:lumen=many
    n5 8:4 highway=street_lamp)",
                                        report);
  ASSERT_EQ(features.points.size(), 5u);
  EXPECT_EQ(features.points[0].lamp_tags,
            (LampTags{.type = LampType::kHighPressureSodium, .mount = LampMount::kBentMast, .count = 2}));
  EXPECT_EQ(features.points[0].height_m, 7);
  EXPECT_EQ(features.points[1].lamp_tags, (LampTags{.type = LampType::kGas, .temperature_k = 2700, .lumen = 600}));
  EXPECT_EQ(features.points[2].lamp_tags, (LampTags{.temperature_k = 2000}));
  EXPECT_EQ(features.points[2].height_m, 5);
  EXPECT_EQ(features.points[3].lamp_tags, LampTags{});
  EXPECT_EQ(features.points[4].lamp_tags, LampTags{});
  EXPECT_EQ(report.counts()[Code::kBadTagValue], 3u);
}

}  // namespace
}  // namespace citykiln::map
