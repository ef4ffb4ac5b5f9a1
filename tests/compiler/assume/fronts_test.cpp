#include "compiler/assume/fronts.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/assume/assume.h"

namespace citykiln::assume {
namespace {

map::Footprint house_of_row(std::int64_t id, double x, double levels) {
  map::Footprint f;
  f.id = {{OsmType::kWay, id}, 0};
  f.polygon.outer = {{x, 0}, {x + 14, 0}, {x + 14, 12}, {x, 12}};
  f.levels = levels, f.height_m = levels * 3;
  return f;
}

// A row of attached houses north of a street whose axis is 5 m from their walls.
map::Features row_of_houses(double levels = 5, map::LandCoverClass street = map::LandCoverClass::kSecondaryRoad) {
  map::Features features;
  features.extent = {{-128, -128}, {1024, 128}};
  for (int i = 0; i < 60; ++i) features.footprints.push_back(house_of_row(i + 1, 14.0 * i, levels));
  map::Track track;
  track.id = {{OsmType::kWay, 999}, 0};
  track.axis = {{-50, -5}, {900, -5}};
  track.surface = street;
  features.tracks.push_back(track);
  return features;
}

map::PointFeature shop_at(double x, double y) {
  map::PointFeature point;
  point.id = {{OsmType::kNode, 7}, 0}, point.at = {x, y}, point.kind = map::PointKind::kShop;
  point.front = map::FrontTags{map::FrontKind::kFood, {}};
  return point;
}

// Marks the footprints that get fronts, and returns the fronts.
std::vector<map::FrontPoint> add_fronts(map::Features& features, Report& report) {
  AssumedFronts made = assume_fronts(features, 1, report);
  for (const std::uint32_t f : made.footprints) features.footprints[f].assumed |= bit_of(Assumption::kFronts);
  return std::move(made.fronts);
}

std::size_t houses_with_fronts(const map::Features& features) {
  return static_cast<std::size_t>(std::ranges::count_if(
      features.footprints, [](const map::Footprint& f) { return has(f.assumed, Assumption::kFronts); }));
}

TEST(AssumedFronts, AreInAShareOfTheHousesAlongAMainStreet) {
  Report report;
  map::Features features = row_of_houses();
  const std::vector<map::FrontPoint> fronts = add_fronts(features, report);
  // a share of 0.6
  EXPECT_GT(houses_with_fronts(features), 24u);
  EXPECT_LT(houses_with_fronts(features), 48u);
  EXPECT_EQ(report.assumed(Assumption::kFronts), houses_with_fronts(features));
  for (const map::FrontPoint& front : fronts) {
    EXPECT_TRUE(front.is_assumed);
    EXPECT_EQ(front.at.y, 0.5);
  }
}

TEST(AssumedFronts, AreMoreAlongMainStreetsThanAlongResidentialOnes) {
  Report report;
  map::Features main = row_of_houses(), residential = row_of_houses(5, map::LandCoverClass::kResidentialRoad),
                track = row_of_houses(5, map::LandCoverClass::kFarmTrack);
  for (map::Features* features : {&main, &residential, &track}) add_fronts(*features, report);
  EXPECT_LT(houses_with_fronts(residential), houses_with_fronts(main));
  EXPECT_EQ(houses_with_fronts(track), 0u);
}

TEST(AssumedFronts, AreNotInLowNorDetachedHouses) {
  Report report;
  map::Features low = row_of_houses(2), detached = row_of_houses();
  for (std::size_t i = 0; i < detached.footprints.size(); i += 2) detached.footprints[i].polygon = {};
  for (map::Features* features : {&low, &detached}) {
    add_fronts(*features, report);
    EXPECT_EQ(houses_with_fronts(*features), 0u);
  }
}

TEST(AssumedFronts, AreNotNearMappedShops) {
  Report report;
  map::Features features = row_of_houses();
  features.points.push_back(shop_at(420, 3));
  const std::vector<map::FrontPoint> fronts = add_fronts(features, report);
  EXPECT_GT(houses_with_fronts(features), 0u);
  for (const map::FrontPoint& front : fronts)
    if (front.is_assumed) {
      EXPECT_GT(distance(front.at, {420, 3}), kFrontSearch_m - 14);
    }
  EXPECT_EQ(std::ranges::count(fronts, false, &map::FrontPoint::is_assumed), 1);
}

TEST(AssumedFronts, DependOnTheirSurroundingsAlone) {
  Report report;
  map::Features all = row_of_houses(), west = row_of_houses();
  west.footprints.resize(30);
  all.points.push_back(shop_at(800, 3));
  for (map::Features* features : {&all, &west}) add_fronts(*features, report);
  for (std::size_t i = 0; i < 29; ++i) EXPECT_EQ(all.footprints[i].assumed, west.footprints[i].assumed) << i;
}

TEST(AssumedFronts, AreNoneIfTheyAreOff) {
  Report report;
  map::Features features = row_of_houses();
  features.points.push_back(shop_at(420, 3));
  const Assumed assumed = assume(features, {kNoAssumptions, 1}, report);
  EXPECT_TRUE(assumed.fronts.empty());
  for (const map::Footprint& f : assumed.footprints) EXPECT_EQ(f.assumed, kNoAssumptions);
}

}  // namespace
}  // namespace citykiln::assume
