#include "compiler/lots/draw_yard.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/geometry/segment.h"
#include "tests/compiler/lots/made_town.h"

namespace citykiln::lots {
namespace {

using map::LandCoverClass;

// A lot of 20 by 30 m north of a street, whose house stands 8 m behind it.
Yard made_yard() {
  return {.building = {{OsmType::kWay, 1000}, 0},
          .country = map::CountryGroup::kBritishIsles,
          .kind = LotKind::kDetached,
          .polygon = {{{0, 0}, {20, 0}, {20, 30}, {0, 30}}, {}},
          .frame = {{10, 0}, kHeadings / 4},
          .setback_m = 8};
}

TEST(FramePlace, IsWithinAStepOfAnyFrame) {
  for (double turns = 0; turns < 1; turns += 0.0137) {
    const Vec2 inward = unit(Vec2{turns - 0.4, 0.5 - turns * turns});
    const Frame frame{{3.3, 4.4}, left_of(inward), inward}, near = frame_at(place_of(frame));
    EXPECT_LE(distance(near.inward, inward), 3.1416 / kHeadings);
    EXPECT_LE(distance(near.origin, frame.origin), kYardStep_m * 0.71);
    EXPECT_NEAR(cross(near.along, near.inward), 1, 1e-12);
    EXPECT_EQ(place_of(near), place_of(frame));
  }
}

TEST(FramePlace, SetbackIsRoundedDown) {
  const FramePlace place{{0, 0}, kHeadings / 4};
  EXPECT_EQ(setback_of(rectangle({2, 5.3}, {9, 9}), place), 5.25);
  EXPECT_EQ(setback_of(rectangle({2, -1}, {9, 9}), place), 0);
  EXPECT_EQ(setback_of({}, place), 0);
}

TEST(BorderLine, FollowsTheRingAndStandsInsideAlongStreets) {
  const Ring ring = made_yard().polygon.outer;
  const std::vector<BorderSegment> segments = border_segments(ring);
  EXPECT_EQ(segments.size(), 200u);
  // from the middle of the east side around two corners
  EXPECT_EQ(border_line(segments, {70, 60, BorderPlace::kElsewhere}), (Polyline{{20, 15}, {20, 30}, {5, 30}}));
  const double inset = inset_m(BorderPlace::kStreet);
  EXPECT_EQ(border_line(segments, {190, 30, BorderPlace::kStreet}),
            (Polyline{{inset, 5}, {inset, inset}, {10, inset}}));
}

TEST(DrawYard, DrawsWhatTheRecipeSays) {
  Yard yard = made_yard();
  yard.strips = {{false, {2, 8.25}, {2, -0.25}}, {true, {-6, 14}, {-6, -0.25}}};
  yard.borders = {{100, 40, BorderPlace::kElsewhere}};
  const DrawnYard drawn = draw_yard(yard, 1);
  const YardRule rule = *rule_of(yard, 1);
  ASSERT_EQ(drawn.areas.size(), rule.front == rule.rear ? 3u : 4u);
  EXPECT_EQ(drawn.areas.front().polygon, yard.polygon);
  EXPECT_TRUE(contains(drawn.areas[drawn.areas.size() - 2].polygon, {12, 4}));
  EXPECT_TRUE(contains(drawn.areas.back().polygon, {4, 12}));
  ASSERT_EQ(drawn.barriers.size(), 1u);
  EXPECT_EQ(drawn.barriers[0].axis, (Polyline{{20, 30}, {0, 30}}));
  EXPECT_TRUE(drawn.plants.empty());
}

// A street of towns has no lawn before its houses, be they a step or some metres behind the pavement.
TEST(DrawYard, FrontsOfTownHousesArePaved) {
  Yard yard = made_yard();
  for (const double setback_m : {0.0, 0.25, 5.0}) {
    yard.setback_m = setback_m, yard.kind = LotKind::kApartments;
    const DrawnYard drawn = draw_yard(yard, 1);
    ASSERT_EQ(drawn.areas.size(), 2u);
    EXPECT_EQ(drawn.areas.back().surface, LandCoverClass::kYardPath);
    EXPECT_TRUE(contains(drawn.areas.back().polygon, {10, setback_m + 1}));
  }
  yard.setback_m = 8;
  EXPECT_NE(draw_yard(yard, 1).areas.back().surface, LandCoverClass::kYardPath);
}

TEST(DrawYard, PlantsStandWhereTheirBitSaysSo) {
  int plants = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Yard yard = made_yard();
    const std::vector<YardPlant> all = plants_drawn(yard, *rule_of(yard, seed), seed);
    for (const YardPlant& plant : all) {
      EXPECT_TRUE(contains(yard.polygon, plant.at));
      EXPECT_GE(distance_to_ring(yard.polygon.outer, plant.at), 0.75);
      EXPECT_EQ(std::ranges::count_if(all, [&](const auto& p) { return distance(p.at, plant.at) < 1.4; }), 1);
    }
    yard.plants.assign(all.size(), false);
    if (!all.empty()) yard.plants.back() = true;
    const DrawnYard drawn = draw_yard(yard, seed);
    ASSERT_EQ(drawn.plants.size(), all.empty() ? 0u : 1u);
    for (const map::PointFeature& plant : drawn.plants) EXPECT_EQ(plant.at, all.back().at);
    plants += static_cast<int>(all.size());
  }
  EXPECT_GT(plants, 40);
}

TEST(DrawYard, AcceptsRecipesThatNoLotHas) {
  Yard yard = made_yard();
  yard.borders = {{5000, 3, BorderPlace::kStreet}, {3, 5000, BorderPlace::kStreet}, {3, 0, BorderPlace::kElsewhere}};
  yard.plants.assign(5000, true);
  yard.strips = {{true, {1, 1}, {1, 1}}};
  EXPECT_TRUE(draw_yard(yard, 1).barriers.empty());
  yard.polygon = {{{0, 0}, {9, 9}, {0, 9}, {9, 0}, {0, 0}}, {{{1, 1}, {1, 1}, {1, 1}}}};
  draw_yard(yard, 1);
  yard.polygon = {};
  EXPECT_TRUE(draw_yard(yard, 1).areas.empty());
  yard = made_yard(), yard.kind = LotKind::kNone;
  EXPECT_TRUE(draw_yard(yard, 1).areas.empty());
}

}  // namespace
}  // namespace citykiln::lots
