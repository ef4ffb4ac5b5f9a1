#include "compiler/cars/bay_places.h"

#include <gtest/gtest.h>

#include <cmath>

namespace citykiln::cars {
namespace {

pitches::Pitch bays(pitches::PitchKind kind, double length_m, double width_m) {
  return {.id = {{OsmType::kWay, 5}, 0}, .kind = kind, .from = {0, 0}, .to = {length_m, 0}, .width_m = width_m};
}

TEST(BayPlaces, LieBetweenThePaintedLines) {
  const auto places = places_in_bays(bays(pitches::PitchKind::kBaysOfRows, 16, 10), map::CountryGroup::kCentralEurope);
  ASSERT_EQ(places.size(), 8u);
  for (const Place& place : places) {
    // lines across the ends at -5, -2.5, 0, 2.5 and 5 m, 5 m deep
    EXPECT_TRUE(place.at.x == 2.5 || place.at.x == 13.5) << place.at.x;
    EXPECT_EQ(std::fmod(std::abs(place.at.y), 2.5), 1.25) << place.at.y;
    EXPECT_EQ(place.ahead, (Vec2{place.at.x > 8 ? 1.0 : -1.0, 0})) << "away from the lane between the rows";
  }
}

TEST(BayPlaces, OfOneRowLieAtItsEnd) {
  const auto places = places_in_bays(bays(pitches::PitchKind::kBaysOfRow, 11, 5), map::CountryGroup::kCentralEurope);
  ASSERT_EQ(places.size(), 2u);
  for (const Place& place : places) EXPECT_EQ(place.at.x, 8.5);
}

TEST(BayPlaces, AreNoneOnOtherPitches) {
  EXPECT_TRUE(places_in_bays(bays(pitches::PitchKind::kRugby, 120, 70), map::CountryGroup::kCentralEurope).empty());
}

TEST(BayPlaces, OfPitchesOfOneAreaHaveKeysOfTheirOwn) {
  pitches::Pitch other = bays(pitches::PitchKind::kBaysOfRows, 16, 10);
  other.from.y += 10, other.to.y += 10;
  const auto a = places_in_bays(bays(pitches::PitchKind::kBaysOfRows, 16, 10), {}), b = places_in_bays(other, {});
  for (const Place& p : a)
    for (const Place& q : b) EXPECT_NE(p.key, q.key);
}

}  // namespace
}  // namespace citykiln::cars
