#include "compiler/ground/cover/dry_cover.h"

#include <gtest/gtest.h>

namespace citykiln::ground {
namespace {

using climate::ClimateClass;
using climate::ClimateMix;
using map::LandCoverClass;

constexpr climate::LocalMonth kFebruary{2}, kAugust{8};

TEST(DryCover, IsNoneInWetClimatesAndOnPavedGround) {
  for (int c = 0; c < static_cast<int>(LandCoverClass::kCount); ++c)
    for (const ClimateClass wet : {ClimateClass::kAf, ClimateClass::kCfb, ClimateClass::kDfb})
      EXPECT_EQ(dry_shares(static_cast<LandCoverClass>(c), ClimateMix(wet), kAugust), DryShares{});
  for (const LandCoverClass paved : {LandCoverClass::kPrimaryRoad, LandCoverClass::kSquare, LandCoverClass::kLake})
    EXPECT_EQ(dry_shares(paved, ClimateMix(ClimateClass::kBWh), kAugust), DryShares{});
}

TEST(DryCover, IsBareInDesertsAndGreenerWhereItIsWatered) {
  const ClimateMix desert(ClimateClass::kBWh);
  EXPECT_EQ(dry_shares(LandCoverClass::kUnknown, desert, kAugust).bare, 1);
  EXPECT_EQ(dry_shares(LandCoverClass::kVerge, desert, kAugust).bare, 1);
  EXPECT_GT(dry_shares(LandCoverClass::kResidential, desert, kAugust).bare, 0.8);
  EXPECT_LT(dry_shares(LandCoverClass::kPark, desert, kAugust).bare, 0.3);
  EXPECT_LT(dry_shares(LandCoverClass::kUnknown, ClimateMix(ClimateClass::kBSk), kAugust).bare, 0.5);
}

TEST(DryCover, IsStrawInDrySummersOnly) {
  const ClimateMix rome(ClimateClass::kCsa);
  EXPECT_GT(dry_shares(LandCoverClass::kMeadow, rome, kAugust).straw, 0.8);
  EXPECT_EQ(dry_shares(LandCoverClass::kMeadow, rome, kFebruary).straw, 0);
}

TEST(DryCover, IsTheMeanOfAMix) {
  ClimateMix half(ClimateClass::kCfb);
  half = {};
  half.add(ClimateClass::kCfb, 0.5), half.add(ClimateClass::kBWh, 0.5);
  EXPECT_EQ(dry_shares(LandCoverClass::kUnknown, half, kAugust).bare, 0.5);
}

TEST(DryCover, IsNowhereInAWetField) {
  EXPECT_FALSE(is_dry_anywhere(climate::uniform_climate(ClimateClass::kCfb), kAugust));
  EXPECT_TRUE(is_dry_anywhere(climate::uniform_climate(ClimateClass::kBWh), kAugust));
  EXPECT_TRUE(is_dry_anywhere(climate::uniform_climate(ClimateClass::kAw), kFebruary));
}

}  // namespace
}  // namespace citykiln::ground
