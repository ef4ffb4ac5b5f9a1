#include "compiler/plants/tufts/place_tufts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/compiler/plants/made_surfaces.h"

namespace citykiln::plants {
namespace {

using ground::LandCoverPolygon;
using map::LandCoverClass;

constexpr Box2 kTuftBox = {{-24, -24}, {24, 24}};
constexpr double kTestSpacing_m = 0.25;

// A lawn with a path along y = 0, a house and a pond.
std::vector<LandCoverPolygon> lawn_with_path(LandCoverClass lawn = LandCoverClass::kPark) {
  return {surface(1, lawn, block(-60, -60, 60, 60)), surface(2, LandCoverClass::kFootPath, block(-60, -1, 60, 1)),
          surface(3, LandCoverClass::kBuilding, block(5, 3, 10, 6)),
          surface(4, LandCoverClass::kLake, block(-10, -6, -5, -3))};
}

struct TuftLand {
  std::vector<LandCoverPolygon> surfaces = lawn_with_path();
  climate::ClimateClass climate = climate::ClimateClass::kCfb;
  Month month = kMidsummer;
  std::uint64_t seed = 7;
  double far_share = 0;
  std::vector<TuftObstacle> obstacles{};

  std::vector<Tuft> in(const Box2& box) const {
    map::Heightfield field{{-128, -128}, {16, 16}, 17, 17, {}, 0};
    field.heights.assign(17 * 17, 0);
    const ground::GradedTerrain graded(std::move(field));
    const climate::ClimateField climates = climate::uniform_climate(climate);
    const Box2 wide = kTuftBox.widened(kTuftReach_m + 1);
    const std::vector<LandCoverPolygon> walked = walked_ground(surfaces, wide);
    const ground::LandCoverIndex cover = index_land_cover(surfaces, wide), walks = index_land_cover(walked, wide);
    return place_tufts({.cover = cover,
                        .walked = walks,
                        .graded = graded,
                        .climate = climates,
                        .month = month,
                        .seed = seed,
                        .far_share = far_share,
                        .obstacles = obstacles},
                       box, kTestSpacing_m);
  }
};

std::multiset<Vec2> tuft_places_of(const std::vector<Tuft>& tufts) {
  std::multiset<Vec2> places;
  for (const Tuft& tuft : tufts) places.insert(in_plan(tuft.placement.at));
  return places;
}

std::size_t flowers_among(const std::vector<Tuft>& tufts) {
  return static_cast<std::size_t>(std::ranges::count_if(
      tufts, [](const Tuft& tuft) { return tuft.form != TuftForm::kMown && tuft.form != TuftForm::kTall; }));
}

TEST(Tufts, KeepOffPathsHousesAndWater) {
  TuftLand land;
  land.far_share = 1;
  const std::vector<Tuft> tufts = land.in(kTuftBox);
  EXPECT_GT(tufts.size(), 10'000u);
  for (const Tuft& tuft : tufts) {
    const Vec2 at = in_plan(tuft.placement.at);
    EXPECT_GE(std::abs(at.y), 1 + kTuftClearance_m);
    EXPECT_FALSE((Box2{{5, 3}, {10, 6}}.widened(kTuftClearance_m / 2).contains(at)));
    EXPECT_FALSE((Box2{{-10, -6}, {-5, -3}}.contains(at)));
    EXPECT_EQ(tuft.surface, 0u);
  }
}

TEST(Tufts, StandWithinReachOfPathsAndThinOut) {
  TuftLand land;
  land.surfaces.resize(2);
  std::size_t near = 0, far = 0;
  for (const Tuft& tuft : land.in(kTuftBox)) {
    const double away_m = std::abs(tuft.placement.at.y) - 1;
    EXPECT_LT(away_m, kTuftReach_m);
    ++(away_m < kTuftReach_m / 2 ? near : far);
  }
  EXPECT_GT(far, 0u);
  EXPECT_GT(near, 4 * far);
}

TEST(Tufts, DependOnSeedAndPlaceAlone) {
  TuftLand land;
  const std::multiset<Vec2> all = tuft_places_of(land.in(kTuftBox));
  std::multiset<Vec2> halves = tuft_places_of(land.in({kTuftBox.min, {3, 24}}));
  halves.merge(tuft_places_of(land.in({{3, -24}, kTuftBox.max})));
  EXPECT_EQ(halves, all);
  EXPECT_EQ(tuft_places_of(land.in(kTuftBox)), all);
  land.seed = 8;
  EXPECT_NE(tuft_places_of(land.in(kTuftBox)), all);
}

// Without assumptions a map has no lawns and verges but those that are mapped.
TEST(Tufts, StandOnMappedOrAssumedGrassAlone) {
  for (const LandCoverClass bare : {LandCoverClass::kResidential, LandCoverClass::kFarmland, LandCoverClass::kUnknown,
                                    LandCoverClass::kForest, LandCoverClass::kSand, LandCoverClass::kPitch})
    EXPECT_TRUE((TuftLand{.surfaces = lawn_with_path(bare), .far_share = 1}.in(kTuftBox).empty()));
  EXPECT_FALSE(TuftLand{.surfaces = lawn_with_path(LandCoverClass::kLawn)}.in(kTuftBox).empty());
}

TEST(Tufts, AreFewInDeserts) {
  const std::size_t moist = TuftLand{}.in(kTuftBox).size();
  TuftLand desert{.surfaces = lawn_with_path(LandCoverClass::kMeadow), .climate = climate::ClimateClass::kBWh};
  const std::vector<Tuft> tufts = desert.in(kTuftBox);
  EXPECT_LT(tufts.size(), moist / 4);
  EXPECT_EQ(flowers_among(tufts), 0u);
}

TEST(Tufts, FlowerInSummer) {
  const std::vector<Tuft> summer = TuftLand{}.in(kTuftBox), winter = TuftLand{.month = Month{1}}.in(kTuftBox);
  EXPECT_EQ(tuft_places_of(summer).size(), tuft_places_of(winter).size());
  EXPECT_GT(flowers_among(summer), summer.size() / 200);
  EXPECT_EQ(flowers_among(winter), 0u);
}

TEST(Tufts, KeepOutOfWalls) {
  const std::vector<TuftObstacle> wall = {{{-30, 2}, {30, 2}, 0.25}};
  for (const Tuft& tuft : TuftLand{.obstacles = wall}.in(kTuftBox)) EXPECT_GE(std::abs(tuft.placement.at.y - 2), 0.25);
}

}  // namespace
}  // namespace citykiln::plants
