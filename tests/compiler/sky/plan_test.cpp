#include "compiler/sky/plan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace citykiln::sky {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

double elevation_deg(const Sky& sky) { return std::asin(sky.to_sun.z) * kDegrees; }
double azimuth_deg(const Sky& sky) {
  const double a = std::atan2(sky.to_sun.x, sky.to_sun.y) * kDegrees;
  return a < 0 ? a + 360 : a;
}

// Reda, Andreas, "Solar Position Algorithm for Solar Radiation Applications", NREL/TP-560-34302, appendix A.5: without
// refraction.
TEST(Plan, AgreesWithTheSolarPositionAlgorithm) {
  const auto sky = plan({-105.1786, 39.742476}, "2003-10-17T19:30:30Z");
  ASSERT_TRUE(sky);
  EXPECT_NEAR(elevation_deg(*sky), 39.872046, 0.012);
  EXPECT_NEAR(azimuth_deg(*sky), 194.34024, 0.012);
}

TEST(Plan, StandsOverTheEquatorAtTheEquinox) {
  const auto sky = plan({0, 0}, "2024-03-20T12:07");
  ASSERT_TRUE(sky);
  EXPECT_GT(elevation_deg(*sky), 89.5);
}

TEST(Plan, DefaultsToAnAfternoonOfSummerEverywhere) {
  for (const map::LonLat place :
       {map::LonLat{1.5, 42.5}, {-87.6, 41.9}, {-51.2, -30}, {174.9, -41.3}, {179.9, 10}, {-179.9, 10}}) {
    const auto sky = plan(place, "");
    ASSERT_TRUE(sky);
    EXPECT_GT(elevation_deg(*sky), 40) << sky->time;
    // in the west
    EXPECT_LT(sky->to_sun.x, -0.3) << sky->time;
    EXPECT_EQ(plan(place, sky->time)->to_sun, sky->to_sun);
  }
}

TEST(Plan, QuantisesAUnitVector) {
  const auto sky = plan({7.4, 43.7}, "2026-01-05T09:15");
  ASSERT_TRUE(sky);
  for (const double c : {sky->to_sun.x, sky->to_sun.y, sky->to_sun.z}) EXPECT_EQ(c * 0x1p20, std::floor(c * 0x1p20));
  EXPECT_NEAR(length(sky->to_sun), 1, 2e-6);
}

TEST(Plan, RejectsInvalidTimes) {
  for (const char* text :
       {"noon", "2026-06-21", "2026-06-21T", "2026-6-21T15:00", "2026-02-30T12:00", "2026-06-21T24:00",
        "2026-06-21T15:60", "2026-06-21 15:00", "2026-06-21T15:00:0", "2026-06-21T15:00+02:00", "2026-06-21T15:00ZZ"}) {
    EXPECT_FALSE(plan({0, 0}, text)) << text;
  }
  EXPECT_TRUE(plan({0, 0}, "2026-06-21T15:00:59Z"));
}

}  // namespace
}  // namespace citykiln::sky
