#include "compiler/assume/roofs.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/compiler/map/map_text.h"

namespace citykiln::assume {
namespace {

using map::CountryGroup;
using map::Footprint;
using roofs::RoofForm;

map::Features with_roofs(const std::string& text, CountryGroup country, std::uint64_t seed = 0) {
  map::Features features = map::features_of(text);
  for (Footprint& f : features.footprints) f.country = country;
  Report report;
  features.footprints = assume_roofs(features, seed, report);
  return features;
}

// Detached houses of 10 m by 8 m and of two storeys.
std::string detached_houses(int count) {
  std::string text;
  for (int i = 0; i < count; ++i)
    text += fmt::format("a{0} {1}:0 {2}:0 {2}:8 {1}:8 building=house building:levels=2\n", i + 1, 20 * i, 20 * i + 10);
  return text;
}

double share_of(RoofForm form, const map::Features& features) {
  const auto count =
      std::ranges::count_if(features.footprints, [&](const Footprint& f) { return f.roof.form == form; });
  return static_cast<double>(count) / static_cast<double>(features.footprints.size());
}

TEST(AssumedRoofs, AreFlatInTheMiddleEastAndPitchedInCentralEurope) {
  const std::string text = detached_houses(60);
  EXPECT_GT(share_of(RoofForm::kFlat, with_roofs(text, CountryGroup::kNorthAfricaAndMiddleEast)), 0.8);
  EXPECT_LT(share_of(RoofForm::kFlat, with_roofs(text, CountryGroup::kCentralEurope)), 0.3);
}

// Houses of 18 m by 14 m and of six storeys in a row.
std::string blocks_in_a_row(int count) {
  std::string text;
  for (int i = 0; i < count; ++i)
    text += fmt::format("a{0} {1}:0 {2}:0 {2}:14 {1}:14 building=apartments building:levels=6\n", i + 1, 18 * i,
                        18 * i + 18);
  return text;
}

TEST(AssumedRoofs, OfFrenchBlocksAreOftenMansardsBetweenPartyWalls) {
  map::Features features = map::features_of(blocks_in_a_row(12));
  for (Footprint& f : features.footprints)
    f.country = CountryGroup::kCentralEurope, f.tradition = map::BuildingTradition::kFrance;
  int mansards = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Report report;
    const std::vector<Footprint> roofed = assume_roofs(features, seed, report);
    mansards += roofed[5].roof.form == RoofForm::kGambrel;
    if (roofed[5].roof.form == RoofForm::kGambrel) {
      EXPECT_EQ(roofed[5].roof_material, materials::Material::kMetalRoof);
      ASSERT_TRUE(roofed[5].roof.direction);
      EXPECT_NEAR(std::abs(roofed[5].roof.direction->y), 1, 1e-9);
    }
  }
  EXPECT_GT(mansards, 6);
  for (Footprint& f : features.footprints) f.tradition = map::BuildingTradition::kOther;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Report report;
    EXPECT_NE(assume_roofs(features, seed, report)[5].roof.form, RoofForm::kGambrel);
  }
}

TEST(AssumedRoofs, LeaveTaggedShapesAlone) {
  const map::Features features =
      with_roofs("a1 0:0 10:0 10:8 0:8 building=house building:levels=2 roof:shape=pyramidal", CountryGroup::kJapan);
  EXPECT_EQ(features.footprints[0].roof.form, RoofForm::kPyramidal);
  EXPECT_EQ(features.footprints[0].assumed, kNoAssumptions);
}

TEST(AssumedRoofs, LeaveTaggedMaterialsAlone) {
  const map::Features features = with_roofs(
      "a1 0:0 10:0 10:8 0:8 building=house building:levels=2 roof:material=copper", CountryGroup::kCentralEurope);
  EXPECT_EQ(features.footprints[0].roof_material,
            map::features_of("a1 0:0 10:0 10:8 0:8 building=house roof:material=copper").footprints[0].roof_material);
}

TEST(AssumedRoofs, HaveAMarkAndThePitchOfTheGroup) {
  const map::Features features = with_roofs(detached_houses(1), CountryGroup::kNorthAmerica);
  EXPECT_TRUE(features.footprints[0].has_roof_shape);
  EXPECT_TRUE(has(features.footprints[0].assumed, Assumption::kRoofs));
  EXPECT_TRUE(features.footprints[0].roof.form == RoofForm::kFlat || features.footprints[0].roof.angle_deg == 24);
}

TEST(AssumedRoofs, AreAlikeInAShortRowWithRidgesAcrossPartyWalls) {
  std::string text;
  for (int i = 0; i < 5; ++i)
    text += fmt::format("a{0} {1}:0 {2}:0 {2}:10 {1}:10 building=house building:levels=2\n", i + 1, 6 * i, 6 * i + 6);
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
    const map::Features features = with_roofs(text, CountryGroup::kBritishIsles, seed);
    for (const Footprint& f : features.footprints) {
      EXPECT_EQ(f.roof.form, features.footprints[0].roof.form);
      if (f.roof.form != RoofForm::kGabled) continue;
      ASSERT_TRUE(f.roof.direction.has_value());
      EXPECT_NEAR(std::abs(f.roof.direction->y), 1, 0.01);
    }
  }
}

TEST(AssumedRoofs, KeepHallsPartsAndOpenRoofsAsTheyAre) {
  const map::Features features = with_roofs(
      "a1 0:0 40:0 40:20 0:20 building=industrial\n"
      "a2 60:0 70:0 70:8 60:8 building=roof\n"
      "a3 80:0 90:0 90:8 80:8 building:part=yes height=9\n",
      CountryGroup::kCentralEurope);
  for (const Footprint& f : features.footprints) EXPECT_EQ(f.assumed, kNoAssumptions);
}

}  // namespace
}  // namespace citykiln::assume
