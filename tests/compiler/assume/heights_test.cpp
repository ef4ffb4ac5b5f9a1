#include "compiler/assume/heights.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "compiler/geometry/snap.h"
#include "tests/compiler/map/map_text.h"

namespace citykiln::assume {
namespace {

using map::Footprint;

map::Features assumed(const std::string& text, std::uint64_t seed = 0) {
  Report report;
  map::Features features = map::features_of(text);
  features.footprints = assume_heights(features, seed, report);
  return features;
}

const Footprint& footprint_of(const map::Features& features, std::int64_t way) {
  return *std::ranges::find_if(features.footprints, [&](const Footprint& f) { return f.id.osm.id == way; });
}

// A house of 10 m by 10 m.
std::string house(int id, double x, const std::string& tags) {
  return fmt::format("a{} {}:0 {}:0 {}:10 {}:10 {}\n", id, x, x + 10, x + 10, x, tags);
}

TEST(AssumedHeights, AreWholeStoreysAsLevelsWouldSay) {
  const map::Features features = assumed(house(1, 0, "building=house"));
  const Footprint& f = footprint_of(features, 1);
  EXPECT_GE(f.levels, 1);
  const map::Features tagged =
      map::features_of(house(1, 0, fmt::format("building=house building:levels={}", f.levels)));
  EXPECT_EQ(f.height_m, footprint_of(tagged, 1).height_m);
  EXPECT_EQ(f.storey_m, footprint_of(tagged, 1).storey_m);
  EXPECT_FALSE(f.has_default_height);
  EXPECT_FALSE(f.has_roof_in_height);
  EXPECT_TRUE(has(f.assumed, Assumption::kHeights));
}

TEST(AssumedHeights, LeaveTaggedHeightsAlone) {
  const map::Features features =
      assumed(house(1, 0, "building=house height=9") + house(2, 30, "building=house building:levels=5"));
  EXPECT_EQ(footprint_of(features, 1).height_m, 9);
  EXPECT_EQ(footprint_of(features, 2).levels, 5);
  for (const Footprint& f : features.footprints) EXPECT_EQ(f.assumed, kNoAssumptions);
}

TEST(AssumedHeights, FollowTaggedNeighbours) {
  std::string text = house(1, 0, "building=apartments");
  for (int i = 1; i < 8; ++i) text += house(i + 1, 10 * i, "building=apartments building:levels=7");
  EXPECT_EQ(footprint_of(assumed(text), 1).levels, 7);
}

TEST(AssumedHeights, IgnoreNeighboursBeyondTheRadius) {
  const std::string alone = house(1, 0, "building=house");
  std::string text = alone;
  for (int i = 0; i < 5; ++i)
    text += house(i + 2, kHeightNeighbours_m + 20 + 15 * i, "building=house building:levels=9");
  EXPECT_EQ(footprint_of(assumed(text), 1).levels, footprint_of(assumed(alone), 1).levels);
}

TEST(AssumedHeights, AreEqualInAShortRow) {
  std::string text;
  for (int i = 0; i < 5; ++i) text += house(i + 1, 10 * i, "building=house");
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const map::Features features = assumed(text, seed);
    const HeightIndex index = index_heights(features);
    const ObjectId first = drawing_member(0, features, index, seed);
    for (std::uint32_t i = 1; i < 5; ++i) EXPECT_EQ(drawing_member(i, features, index, seed), first);
  }
}

TEST(AssumedHeights, DoNotDependOnTheOrderOfFootprints) {
  std::string text;
  for (int i = 0; i < 6; ++i)
    text += house(i + 1, 12 * i, i % 2 == 0 ? "building=yes" : "building=yes building:levels=3");
  map::Features features = map::features_of(text);
  Report report;
  const std::vector<Footprint> forward = assume_heights(features, 0, report);
  std::ranges::reverse(features.footprints);
  map::Features backward = features;
  backward.footprints = assume_heights(features, 0, report);
  for (const Footprint& f : forward) EXPECT_EQ(f.levels, footprint_of(backward, f.id.osm.id).levels);
}

TEST(AssumedHeights, KeepClassesWithAHeightOfTheirOwn) {
  const map::Features features =
      assumed(house(1, 0, "building=garage") + house(2, 30, "building=roof") + house(3, 60, "building=church"));
  for (const Footprint& f : features.footprints) EXPECT_EQ(f.assumed, kNoAssumptions);
}

TEST(AssumedHeights, PartsWithoutHeightFollowTheirOutline) {
  const map::Features features = assumed(
      "a1 0:0 20:0 20:10 0:10 building=apartments\n"
      "a2 0:0 10:0 10:10 0:10 building:part=yes\n");
  const Footprint& outline = footprint_of(features, 1);
  EXPECT_EQ(footprint_of(features, 2).height_m, outline.height_m);
  for (const Footprint& f : features.footprints) EXPECT_LT(f.min_height_m, f.height_m);
}

TEST(AssumedHeights, ASingleHouseInASuburbIsLow) {
  HeightFacts facts{.building_class = map::BuildingClass::kPlain, .use = SiteUse::kHomes, .area_m2 = 180};
  facts.built_share = 0.14, facts.mean_area_m2 = 120, facts.row_share = 0.05;
  for (const auto country : {map::CountryGroup::kNorthAmerica, map::CountryGroup::kCentralEurope}) {
    facts.country = country;
    EXPECT_LE(storeys_by_table(facts).high, 2);
  }
}

TEST(AssumedHeights, TheTableHasARowForAllFacts) {
  HeightFacts facts;
  for (const auto building_class : {map::BuildingClass::kPlain, map::BuildingClass::kOffice, map::BuildingClass::kBarn})
    for (int group = 0; group < static_cast<int>(map::CountryGroup::kCount); ++group)
      for (const double area_m2 : {5.0, 60.0, 120.0, 300.0, 900.0, 5000.0})
        for (const double built : {0.02, 0.15, 0.3, 0.5})
          for (const double row_share : {0.0, 0.5, 1.0}) {
            facts = {.building_class = building_class, .country = static_cast<map::CountryGroup>(group)};
            facts.area_m2 = facts.mean_area_m2 = area_m2, facts.built_share = built, facts.row_share = row_share;
            const StoreyQuartiles storeys = storeys_by_table(facts);
            EXPECT_LE(storeys.low, storeys.middle);
            EXPECT_LE(storeys.middle, storeys.high);
          }
}

TEST(AssumedHeights, LeftOutTagsAreNotUsed) {
  const map::Features features = map::features_of(house(1, 0, "building=apartments building:levels=9") +
                                                  house(2, 10, "building=apartments building:levels=9"));
  const HeightIndex index = index_heights(features);
  EXPECT_EQ(storeys_of(0, index).middle, 9);
  EXPECT_EQ(storeys_of(0, index, [](std::uint32_t) { return false; }), storeys_by_table(index.facts[0]));
}

}  // namespace
}  // namespace citykiln::assume
