#include "compiler/people/body.h"

#include <gtest/gtest.h>

#include <set>

namespace citykiln::people {
namespace {

TEST(Body, IsItsForm) {
  for (std::uint16_t i = 0; i < kBodies; ++i) {
    const things::Form form = form_of({i, map::CountryGroup::kJapan, Season::kCold});
    const std::optional<Body> body = body_of(form);
    ASSERT_TRUE(body);
    EXPECT_EQ(body->number, i);
    EXPECT_EQ(body->country, map::CountryGroup::kJapan);
    EXPECT_EQ(body->season, Season::kCold);
    EXPECT_LE(form.height_m, kTallestPerson_m);
  }
  EXPECT_FALSE(body_of({.kind = "bench"}));
}

TEST(Body, FitsTheStance) {
  for (double draw = 0; draw < 1; draw += 0.01) {
    const auto pose = [&](Stance stance, bool with_children) {
      return look_of({drawn_body(stance, with_children, draw), {}, {}}, 1);
    };
    EXPECT_EQ(pose(Stance::kWalking, true).pose, Pose::kWalk);
    EXPECT_EQ(pose(Stance::kSitting, false).pose, Pose::kSit);
    EXPECT_NE(pose(Stance::kStanding, false).pose, Pose::kWalk);
    EXPECT_NE(pose(Stance::kStanding, false).pose, Pose::kSit);
    EXPECT_NE(pose(Stance::kStanding, false).figure, Figure::kChild);
  }
}

TEST(Body, DrawsAllBodies) {
  std::set<std::uint16_t> drawn;
  for (const Stance stance : {Stance::kWalking, Stance::kStanding, Stance::kSitting})
    for (double draw = 0; draw < 1; draw += 0.005) drawn.insert(drawn_body(stance, true, draw));
  EXPECT_EQ(drawn.size(), kBodies);
}

TEST(Body, HasClothesOfTheSeason) {
  EXPECT_EQ(season_of(7), Season::kWarm);
  EXPECT_EQ(season_of(10), Season::kMild);
  EXPECT_EQ(season_of(1), Season::kCold);
  int caps = 0;
  for (std::uint16_t i = 0; i < kBodies; ++i) {
    EXPECT_FALSE(look_of({i, {}, Season::kWarm}, 1).has_cap);
    EXPECT_NE(look_of({i, {}, Season::kCold}, 1).legs, LegWear::kShorts);
    caps += look_of({i, {}, Season::kCold}, 1).has_cap;
  }
  EXPECT_GT(caps, 3);
}

// The mean reflectance of skin.
double skin_in(map::CountryGroup country) {
  double sum = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed)
    for (std::uint16_t i = 0; i < kBodies; ++i) sum += look_of({i, country, {}}, seed).skin[0];
  return sum / (20 * kBodies);
}

TEST(Body, HasLooksOfTheRegion) {
  EXPECT_GT(skin_in(map::CountryGroup::kNorthernEurope), 1.5 * skin_in(map::CountryGroup::kTropicalAfrica));
  EXPECT_GT(skin_in(map::CountryGroup::kJapan), 1.3 * skin_in(map::CountryGroup::kSouthAsia));
}

}  // namespace
}  // namespace citykiln::people
