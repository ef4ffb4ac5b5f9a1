#include "compiler/fields/field_rules.h"

#include <gtest/gtest.h>

#include <map>

namespace citykiln::fields {
namespace {

TEST(FieldRules, SizesAreThoseOfTheRegion) {
  EXPECT_GT(field_rule_at({13.26, 53.55}).area_m2, 10e4);              // Neubrandenburg
  EXPECT_LT(field_rule_at({10.0, 49.0}).area_m2, 4e4);                 // Franconia
  EXPECT_EQ(field_rule_at({-8.6, 52.7}).border, FieldBorder::kHedge);  // Limerick
  EXPECT_EQ(field_rule_at({-0.9, 48.9}).border, FieldBorder::kHedge);  // Normandy
  EXPECT_LT(field_rule_at({9.5, 47.1}).area_m2, 1e4);                  // Liechtenstein
  EXPECT_GT(field_rule_at({5.0, 52.2}).aspect, 4);                     // Utrecht
  EXPECT_TRUE(field_rule_at({-98, 40}).is_grid);                       // Nebraska
  EXPECT_FALSE(field_rule_at({-71, 42.4}).is_grid);                    // Massachusetts
}

TEST(FieldRules, EveryGroupHasCrops) {
  for (int g = 0; g < static_cast<int>(map::CountryGroup::kCount); ++g) {
    std::map<map::LandCoverClass, int> counts;
    for (int i = 0; i < 400; ++i)
      ++counts[crop_at({static_cast<map::CountryGroup>(g), climate::ClimateClass::kCfb}, (i + 0.5) / 400)];
    EXPECT_GE(counts.size(), 4u);
    for (const auto& [crop, count] : counts) EXPECT_TRUE(map::is_field(crop));
  }
}

TEST(FieldRules, RiceGrowsInJapanAndNotInGermany) {
  const auto rice = [](map::CountryGroup group) {
    int count = 0;
    for (int i = 0; i < 100; ++i)
      count += crop_at({group, climate::ClimateClass::kCfa}, i / 100.0) == map::LandCoverClass::kRicePaddy;
    return count;
  };
  EXPECT_GT(rice(map::CountryGroup::kJapan), 50);
  EXPECT_EQ(rice(map::CountryGroup::kCentralEurope), 0);
}

}  // namespace
}  // namespace citykiln::fields
