#include "compiler/people/presence.h"

#include <gtest/gtest.h>

#include <cmath>

namespace citykiln::people {
namespace {

constexpr buildings::WeekTime kNoon{60}, kNight{51};

Spot spot_of(SpotUse use, map::CountryGroup country = {}) {
  return {.key = StableId{1}, .extent = 3, .use = use, .country = country};
}

TEST(Presence, IsGreatestBeforeShopsByDay) {
  EXPECT_GT(usual_presence(spot_of(SpotUse::kShops), kNoon), 3 * usual_presence(spot_of(SpotUse::kHouses), kNoon));
  EXPECT_GT(usual_presence(spot_of(SpotUse::kHouses), kNoon), 2 * usual_presence(spot_of(SpotUse::kOpen), kNoon));
  EXPECT_GT(usual_presence(spot_of(SpotUse::kShops), kNoon), 10 * usual_presence(spot_of(SpotUse::kShops), kNight));
}

TEST(Presence, FollowsTheCountry) {
  EXPECT_GT(usual_presence(spot_of(SpotUse::kHouses, map::CountryGroup::kCentralEurope), kNoon),
            1.5 * usual_presence(spot_of(SpotUse::kHouses, map::CountryGroup::kNorthAmerica), kNoon));
}

TEST(Presence, IsAShareContinuousOverTheWeek) {
  for (std::size_t use = 0; use < static_cast<std::size_t>(SpotUse::kCount); ++use) {
    const Spot spot = spot_of(static_cast<SpotUse>(use));
    double last = usual_presence(spot, {0});
    for (double hours = 0.25; hours <= 168; hours += 0.25) {
      const double share = usual_presence(spot, {std::fmod(hours, 168)});
      EXPECT_GE(share, 0);
      EXPECT_LE(share, 1);
      EXPECT_NEAR(share, last, 0.1) << hours;
      last = share;
    }
  }
}

TEST(Presence, WhoIsThereStaysWhenTheShareRises) {
  for (std::uint64_t key = 0; key < 200; ++key) {
    Spot spot = spot_of(SpotUse::kShops);
    spot.key = StableId{key};
    if (is_somebody_at(spot, {.share = 0.25}, kNoon, 1)) {
      EXPECT_TRUE(is_somebody_at(spot, {.share = 0.5}, kNoon, 1));
    }
    EXPECT_TRUE(is_somebody_at(spot, {.share = 1}, kNoon, 1));
    EXPECT_FALSE(is_somebody_at(spot, kNobody, kNoon, 1));
  }
}

}  // namespace
}  // namespace citykiln::people
