#include "compiler/things/on_roofs.h"

#include <gtest/gtest.h>

namespace citykiln::things {
namespace {

using map::Stand;

// A flat roof at 120 m over ground at 100 m.
buildings::Building flat_house() {
  buildings::Building b;
  b.id = {{OsmType::kWay, 7}, 0};
  b.footprint.outer = {{0, 0}, {20, 0}, {20, 10}, {0, 10}};
  b.bottom_m = 98, b.floor_m = 100, b.top_m = 120;
  b.levels = 6;
  return b;
}

buildings::Building gabled_house() {
  buildings::Building b = flat_house();
  b.roof_shape.form = roofs::RoofForm::kGabled, b.roof_shape.height_m = 4;
  return b;
}

constexpr RoofBelow kBelow{.ground_m = 100, .roof_m = 120};

map::ThingFeature thing(double height_m, bool has_height, double min_height_m = 0) {
  map::ThingFeature thing;
  thing.height_m = height_m, thing.has_height = has_height, thing.min_height_m = min_height_m;
  return thing;
}

TEST(OnRoofs, TheRoofBelowAPlaceIsItsSurfaceThere) {
  const std::vector flat{flat_house()}, gabled{gabled_house()};
  EXPECT_EQ(Roofs(flat).below({5, 5}, 0.5)->roof_m, 120);
  EXPECT_EQ(Roofs(flat).below({5, 5}, 0.5)->ground_m, 100);
  EXPECT_FALSE(Roofs(flat).below({25, 5}, 0.5));
  EXPECT_NEAR(Roofs(gabled).below({10, 5}, 0)->roof_m, 120, 0.01) << "the ridge";
  EXPECT_NEAR(Roofs(gabled).below({10, 2.5}, 0)->roof_m, 118, 0.01) << "half-way down";
  EXPECT_NEAR(Roofs(gabled).below({10, 5}, 1)->roof_m, 119.2, 0.01) << "the lower side of its base";
}

TEST(OnRoofs, OfPartsTheHighestRoofCountsAndTheGroundOfTheLowest) {
  buildings::Building part = flat_house();
  part.bottom_m = part.floor_m = 120, part.top_m = 140, part.stands_on_ground = false;
  const std::vector both{flat_house(), part};
  EXPECT_EQ(Roofs(both).below({5, 5}, 0)->roof_m, 140);
  EXPECT_EQ(Roofs(both).below({5, 5}, 0)->ground_m, 100);
}

TEST(OnRoofs, ALowThingStandsOnTheRoofWithItsOwnHeight) {
  const FootOnRoof foot = foot_on_roof(thing(6, true), Stand::kRoof, kBelow);
  EXPECT_EQ(foot.foot_m, 120);
  EXPECT_EQ(foot.height_m, 6);
}

TEST(OnRoofs, AHeightAboveTheRoofCountsFromTheGround) {
  const FootOnRoof mast = foot_on_roof(thing(32, true), Stand::kRoof, kBelow);
  EXPECT_EQ(mast.foot_m, 120);
  EXPECT_EQ(mast.height_m, 12);
  map::ThingFeature on_roof = thing(32, true);
  on_roof.is_on_roof = true;
  EXPECT_EQ(foot_on_roof(on_roof, Stand::kRoof, kBelow).height_m, 32) << "location=roof: its own height";
}

TEST(OnRoofs, AChimneyHigherThanItsBuildingGrowsOutOfTheGround) {
  const FootOnRoof high = foot_on_roof(thing(40, true), Stand::kThroughRoof, kBelow);
  EXPECT_FALSE(high.foot_m);
  EXPECT_EQ(high.height_m, 40);
  const FootOnRoof low = foot_on_roof(thing(3, true), Stand::kThroughRoof, kBelow);
  EXPECT_EQ(low.foot_m, 120);
  EXPECT_EQ(low.height_m, 3);
}

TEST(OnRoofs, AMinHeightIsTheFootButNoneIsInTheAir) {
  const FootOnRoof antenna = foot_on_roof(thing(32, true, 20), Stand::kRoof, kBelow);
  EXPECT_EQ(antenna.foot_m, 120);
  EXPECT_EQ(antenna.height_m, 12);
  EXPECT_EQ(foot_on_roof(thing(8, true, 15), Stand::kRoof, kBelow).foot_m, 115);
  EXPECT_EQ(foot_on_roof(thing(8, true, 50), Stand::kRoof, kBelow).foot_m, 120) << "above the roof";
}

TEST(OnRoofs, AHeightThatIsNotTaggedIsInProportionToTheBuilding) {
  EXPECT_EQ(foot_on_roof(thing(30, false), Stand::kRoof, kBelow).height_m, 10);
  EXPECT_EQ(foot_on_roof(thing(8, false), Stand::kRoof, kBelow).height_m, 8);
}

}  // namespace
}  // namespace citykiln::things
