#include "compiler/climate/climate_field.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compiler/climate/climate_at.h"

namespace citykiln::climate {
namespace {

// A plane about a place; a degree has 111.2 km.
auto degrees_about(LonLat origin) {
  return [origin](Vec2 at) {
    return LonLat{origin.lon_deg + at.x / 111200 / std::cos(origin.lat_deg * 3.14159265 / 180),
                  origin.lat_deg + at.y / 111200};
  };
}

constexpr LonLat kRome{12.5, 41.9}, kLagos{3.39, 7.9};

double share_of(const ClimateMix& mix, ClimateClass climate) {
  return mix.mean([&](ClimateClass each) { return each == climate ? 1.0 : 0.0; });
}

TEST(ClimateField, HasTheOriginsClassAndSoundNodes) {
  const ClimateField field = make_climate_field({{-1024, -1024}, {1024, 1024}}, degrees_about(kRome));
  EXPECT_EQ(field.origin_class, ClimateClass::kCsa);
  EXPECT_TRUE(is_sound(field));
  EXPECT_EQ(field.nodes.size(), 9u);
}

// Two extents that overlap give the same bits: a place's climate does not depend on the extent.
TEST(ClimateField, IsTheSameFromAnyExtent) {
  const ClimateField small = make_climate_field({{2048, -4096}, {9216, 20480}}, degrees_about(kLagos));
  const ClimateField large = make_climate_field({{-60000, -80000}, {50000, 120000}}, degrees_about(kLagos));
  for (double y = -4096; y <= 20480; y += 512)
    for (const ClimateShare& each : climate_mix_at(small, {5000, y}).shares())
      EXPECT_EQ(each.share, share_of(climate_mix_at(large, {5000, y}), each.climate)) << y;
}

TEST(ClimateField, FollowsTheTableWithinTheSpacingOfItsNodes) {
  const auto degrees_of = degrees_about(kLagos);
  const ClimateField field = make_climate_field({{0, 0}, {80000, 500000}}, degrees_of);
  double largest = 0;
  for (double y = 0; y < 500000; y += 3000)
    for (const double x : {100.0, 40000.0, 79000.0}) {
      const LonLat at = degrees_of({x, y});
      const ClimateMix mix = climate_mix_at(field, {x, y}), exact = climate_mix_at(at.lon_deg, at.lat_deg);
      for (const ClimateShare& each : exact.shares())
        largest = std::max(largest, std::abs(each.share - share_of(mix, each.climate)));
    }
  EXPECT_LT(largest, 0.2);
}

TEST(ClimateField, ChangesGradually) {
  const ClimateField field = make_climate_field({{0, 0}, {1000, 500000}}, degrees_about(kLagos));
  for (double y = 0; y < 500000; y += 100)
    for (const ClimateShare& each : climate_mix_at(field, {500, y}).shares())
      EXPECT_NEAR(each.share, share_of(climate_mix_at(field, {500, y + 100}), each.climate), 0.01);
}

TEST(ClimateField, IsOneClassWhereItIsUniform) {
  const ClimateField field = uniform_climate(ClimateClass::kBWh);
  EXPECT_TRUE(is_sound(field));
  for (const Vec2 at : {Vec2{}, Vec2{1e6, -1e6}}) {
    const ClimateMix mix = climate_mix_at(field, at);
    ASSERT_EQ(mix.shares().size(), 1u);
    EXPECT_EQ(mix.shares()[0].climate, ClimateClass::kBWh);
    EXPECT_EQ(mix.shares()[0].share, 1);
  }
}

TEST(ClimateField, IsNotSoundWithOtherNumbers) {
  const ClimateField sound = uniform_climate(ClimateClass::kBWh);
  ClimateField field = sound;
  field.origin_class = ClimateClass::kCount;
  EXPECT_FALSE(is_sound(field));
  field = sound, field.columns = 0;
  EXPECT_FALSE(is_sound(field));
  field = sound, field.columns = 2;
  EXPECT_FALSE(is_sound(field));
  field = sound, field.nodes[0].shares[0] = 254;
  EXPECT_FALSE(is_sound(field));
  field = sound, field.nodes[0].classes[3] = ClimateClass::kCount;
  EXPECT_FALSE(is_sound(field));
  field = sound, field.nodes.clear();
  EXPECT_FALSE(is_sound(field));
}

}  // namespace
}  // namespace citykiln::climate
