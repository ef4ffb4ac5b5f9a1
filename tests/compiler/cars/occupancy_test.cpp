#include "compiler/cars/occupancy.h"

#include <gtest/gtest.h>

#include <cmath>

namespace citykiln::cars {
namespace {

constexpr buildings::WeekTime kNoon{60}, kNight{51};

Place place(map::CountryGroup country, PlaceKind kind, PlaceUse use) {
  return {.key = StableId{1}, .kind = kind, .use = use, .country = country};
}

double at_kerbs(map::CountryGroup country, buildings::WeekTime time) {
  return usual_share(place(country, PlaceKind::kKerb, PlaceUse::kHomeStreet), time);
}

TEST(Occupancy, IsFullInSouthernEuropeAndAlmostNoneAtKerbsOfJapan) {
  EXPECT_GT(at_kerbs(map::CountryGroup::kSouthernEurope, kNoon), 0.85);
  EXPECT_LT(at_kerbs(map::CountryGroup::kJapan, kNoon), 0.05);
  EXPECT_LT(at_kerbs(map::CountryGroup::kNorthAmerica, kNoon), 0.4);
}

TEST(Occupancy, FollowsTheHour) {
  const Place home = place({}, PlaceKind::kKerb, PlaceUse::kHomeStreet),
              shop = place({}, PlaceKind::kBay, PlaceUse::kCarPark);
  EXPECT_GT(usual_share(home, kNight), usual_share(home, kNoon));
  EXPECT_LT(usual_share(shop, kNight), usual_share(shop, kNoon) / 3);
}

TEST(Occupancy, IsAShareContinuousOverTheWeek) {
  for (std::size_t use = 0; use < static_cast<std::size_t>(PlaceUse::kCount); ++use)
    for (std::size_t country = 0; country < static_cast<std::size_t>(map::CountryGroup::kCount); ++country) {
      const Place p = place(static_cast<map::CountryGroup>(country), PlaceKind::kLane, static_cast<PlaceUse>(use));
      double last = usual_share(p, {0});
      for (double hours = 0.25; hours <= 168; hours += 0.25) {
        const double share = usual_share(p, {std::fmod(hours, 168)});
        EXPECT_GE(share, 0);
        EXPECT_LE(share, 1);
        EXPECT_NEAR(share, last, 0.08) << hours;
        last = share;
      }
    }
}

TEST(Occupancy, ATakenPlaceStaysTakenWhenTheShareRises) {
  for (std::uint64_t key = 0; key < 200; ++key) {
    Place p = place({}, PlaceKind::kKerb, PlaceUse::kHomeStreet);
    p.key = StableId{key};
    if (is_taken(p, {.share = 0.25}, kNoon, 1)) {
      EXPECT_TRUE(is_taken(p, {.share = 0.5}, kNoon, 1));
    }
    EXPECT_TRUE(is_taken(p, {.share = 1}, kNoon, 1));
    EXPECT_FALSE(is_taken(p, kNoCars, kNoon, 1));
  }
}

}  // namespace
}  // namespace citykiln::cars
