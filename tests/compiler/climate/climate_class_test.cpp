#include "compiler/climate/climate_class.h"

#include <gtest/gtest.h>

namespace citykiln::climate {
namespace {

constexpr LocalMonth kJanuary{1}, kApril{4}, kAugust{8}, kOctober{10};

TEST(ClimateClass, IsFoundByItsName) {
  for (std::size_t c = 0; c < kClimateClasses; ++c)
    EXPECT_EQ(climate_named(name_of(static_cast<ClimateClass>(c))), static_cast<ClimateClass>(c));
  for (const char* name : {"", "Cf", "cfb", "Cfbb", "kCfb"}) EXPECT_EQ(climate_named(name), ClimateClass::kCount);
}

TEST(ClimateClass, HasNoSeasonOfLeavesInTheTropics) {
  for (const ClimateClass climate : {ClimateClass::kAf, ClimateClass::kAm, ClimateClass::kAs, ClimateClass::kAw})
    for (std::uint8_t month = 1; month <= 12; ++month) EXPECT_EQ(equivalent_month(climate, LocalMonth{month}), 6);
}

TEST(ClimateClass, HasLeavesLaterAndShorterWhereWintersAreLong) {
  EXPECT_EQ(equivalent_month(ClimateClass::kCfb, kApril), 4);
  EXPECT_LT(equivalent_month(ClimateClass::kDfc, kApril), 4);
  EXPECT_GT(equivalent_month(ClimateClass::kDfc, kOctober), 10);
  EXPECT_LT(equivalent_month(ClimateClass::kCsa, kOctober), 10);
}

TEST(ClimateClass, HasStrawInDrySummersAndAllYearInDeserts) {
  EXPECT_GT(straw_share(ClimateClass::kCsa, kAugust), 0.8);
  EXPECT_EQ(straw_share(ClimateClass::kCsa, kJanuary), 0);
  EXPECT_GT(straw_share(ClimateClass::kAw, kJanuary), 0.4);
  EXPECT_EQ(straw_share(ClimateClass::kAw, kAugust), 0);
  for (std::uint8_t month = 1; month <= 12; ++month) {
    EXPECT_GE(straw_share(ClimateClass::kBWh, LocalMonth{month}), 0.9);
    EXPECT_EQ(straw_share(ClimateClass::kCfb, LocalMonth{month}), 0);
  }
  EXPECT_EQ(bare_share(ClimateClass::kBWh), 1);
  EXPECT_EQ(bare_share(ClimateClass::kDfb), 0);
}

TEST(ClimateClass, HasSnowInColdWintersOnly) {
  EXPECT_TRUE(is_under_snow(ClimateClass::kDfb, kJanuary));
  EXPECT_FALSE(is_under_snow(ClimateClass::kDfb, kAugust));
  EXPECT_FALSE(is_under_snow(ClimateClass::kCfb, kJanuary));
  EXPECT_TRUE(is_under_snow(ClimateClass::kEF, kAugust));
  for (std::size_t c = 0; c < kClimateClasses; ++c) {
    const auto climate = static_cast<ClimateClass>(c);
    EXPECT_TRUE(has_cold_winters(climate) || !is_under_snow(climate, kJanuary)) << name_of(climate);
  }
}

}  // namespace
}  // namespace citykiln::climate
