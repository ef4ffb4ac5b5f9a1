#include "compiler/sky/plan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <numbers>

#include "compiler/sky/air_settings.h"
#include "compiler/sky/stars.h"

namespace citykiln::sky {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

Sky planned(LonLat place, const std::string& time) { return plan(place, *parse_time(time)); }

double elevation_deg(const Sky& sky) { return std::asin(sky.to_sun.z) * kDegrees; }
double azimuth_deg(const Sky& sky) {
  const double a = std::atan2(sky.to_sun.x, sky.to_sun.y) * kDegrees;
  return a < 0 ? a + 360 : a;
}

// Reda, Andreas, "Solar Position Algorithm for Solar Radiation Applications", NREL/TP-560-34302, appendix A.5, whose
// height is lifted by refraction: 0.016 degrees at 820 hPa, 0.020 at sea level.
TEST(Plan, AgreesWithTheSolarPositionAlgorithm) {
  const Sky sky = planned({-105.1786, 39.742476}, "2003-10-17T19:30:30Z");
  EXPECT_NEAR(elevation_deg(sky), 39.872046 + 0.020, 0.012);
  EXPECT_NEAR(azimuth_deg(sky), 194.34024, 0.012);
}

TEST(Plan, StandsOverTheEquatorAtTheEquinox) {
  const Sky sky = planned({0, 0}, "2024-03-20T12:07");
  EXPECT_GT(elevation_deg(sky), 89.5);
}

TEST(Plan, DefaultsToAnAfternoonOfSummerEverywhere) {
  for (const LonLat place :
       {LonLat{1.5, 42.5}, {-87.6, 41.9}, {-51.2, -30}, {174.9, -41.3}, {179.9, 10}, {-179.9, 10}}) {
    const Sky sky = plan(place, {});
    EXPECT_GT(elevation_deg(sky), 40) << text_of(sky.time);
    // in the west
    EXPECT_LT(sky.to_sun.x, -0.3) << text_of(sky.time);
    EXPECT_EQ(plan(place, sky.time).to_sun, sky.to_sun);
  }
}

TEST(Plan, QuantisesAUnitVector) {
  const Sky sky = planned({7.4, 43.7}, "2026-01-05T09:15");
  for (const double c : {sky.to_sun.x, sky.to_sun.y, sky.to_sun.z}) EXPECT_EQ(c * 0x1p20, std::floor(c * 0x1p20));
  EXPECT_NEAR(length(sky.to_sun), 1, 2e-6);
}

// A row of almanac.inc: directions are east, north, up.
struct AlmanacRow {
  LonLat place;
  const char* time;
  double moon_lit;
  Vec3 sun, moon, sirius, vega, polaris, acrux;
};
constexpr AlmanacRow kAlmanac[] = {
#include "tests/compiler/sky/almanac.inc"
};

double between_deg(Vec3 a, Vec3 b) { return std::atan2(length(cross(a, b)), dot(a, b)) * kDegrees; }

TEST(Plan, AgreesWithAnAlmanacAtTwentyPlacesAndTimes) {
  ASSERT_EQ(std::size(kAlmanac), 20u);
  for (const AlmanacRow& row : kAlmanac) {
    const Sky sky = planned(row.place, row.time);
    EXPECT_LT(between_deg(sky.to_sun, row.sun), 0.05) << row.time;
    EXPECT_LT(between_deg(sky.to_moon, row.moon), 0.2) << row.time;
    EXPECT_NEAR(sky.moon_lit, row.moon_lit, 0.005) << row.time;
  }
}

TEST(StarDirection, AgreesWithAnAlmanacAtTwentyPlacesAndTimes) {
  for (const AlmanacRow& row : kAlmanac) {
    const Sky sky = planned(row.place, row.time);
    EXPECT_LT(between_deg(star_direction(sky, 101.287215, -16.7161), row.sirius), 0.1) << row.time;
    EXPECT_LT(between_deg(star_direction(sky, 279.234735, 38.7837), row.vega), 0.1) << row.time;
    EXPECT_LT(between_deg(star_direction(sky, 37.95453, 89.2641), row.polaris), 0.1) << row.time;
    EXPECT_LT(between_deg(star_direction(sky, 186.64962, -63.0991), row.acrux), 0.1) << row.time;
  }
}

TEST(StarsOf, AreThoseAboveTheHorizonBrightestFirst) {
  const Sky sky = planned({1.5, 42.5}, "2026-01-10T22:00");
  const std::vector<Star> stars = stars_of(sky);
  EXPECT_GT(stars.size(), 300u);
  EXPECT_LT(stars.size(), 700u);
  EXPECT_LT(between_deg(stars.front().direction, star_direction(sky, 101.287, -16.716)), 1e-3);  // Sirius
  for (const Star& star : stars) EXPECT_GE(star.direction.z, 0);
}

TEST(Plan, ReadsOffsetsFromUtc) {
  const Sky utc = planned({1.5, 42.5}, "2026-01-01T00:30:00Z");
  for (const char* text :
       {"2026-01-01T02:30+02:00", "2025-12-31T20:00-04:30", "2025-12-31T20:00-0430", "2026-01-01T02:30:00+02"}) {
    const Sky sky = planned({1.5, 42.5}, text);
    EXPECT_EQ(sky.time, utc.time) << text;
    EXPECT_EQ(sky, utc) << text;
  }
}

// Refraction fades from that at -1 degree to nothing at the nadir.
TEST(Plan, IsTotalAtThePoles) {
  for (const double lat : {-90.0, 90.0}) {
    const Sky sky = planned({0, lat}, "2026-06-21T12:00");
    EXPECT_NEAR(elevation_deg(sky), lat > 0 ? 23.48 : -22.95, 0.02);
  }
}

TEST(SetAir, ATurbidityAloneSetsTheVisibility) {
  Sky sky;
  set_air({.turbidity = 2.6}, sky);
  EXPECT_NEAR(sky.visibility_km, Sky{}.visibility_km, 1);
  set_air({.turbidity = 8}, sky);
  EXPECT_LT(sky.visibility_km, 40);
  set_air({.turbidity = 8, .visibility_km = 70}, sky);
  EXPECT_EQ(sky.visibility_km, 70);
}

TEST(Moment, RejectsInvalidTimes) {
  for (const char* text :
       {"noon", "2026-06-21", "2026-06-21T", "2026-6-21T15:00", "2026-02-30T12:00", "2026-06-21T24:00",
        "2026-06-21T15:60", "2026-06-21 15:00", "2026-06-21T15:00:0", "2026-06-21T15:00+2", "2026-06-21T15:00+15:00",
        "2026-06-21T15:00+02:60", "2026-06-21T15:00Z+01", "2026-06-30T23:59:60", "2026-06-21T15:00+",
        "0000-01-01T00:00+01:00", "2026-06-21T15:00ZZ"}) {
    EXPECT_FALSE(parse_time(text)) << text;
  }
  EXPECT_TRUE(parse_time("2026-06-21T15:00:59Z"));
}

TEST(Moment, KeepsTheTextOfATimeInUtc) {
  for (const char* ending : {"", "Z", "+00:00", "+0000", "+00", "-00:00", "-0000", "-00"})
    for (const char* minute : {"2026-06-21T15:00", "0000-01-01T00:00:00", "9999-12-31T23:59:59"}) {
      const std::string text = std::string(minute) + ending;
      const Result<Moment> moment = parse_time(text);
      ASSERT_TRUE(moment) << text;
      EXPECT_EQ(text_of(*moment), text);
    }
  EXPECT_EQ(text_of({}), "");
}

TEST(Moment, IsWhatItsTextIsParsedAs) {
  for (const char* text : {"2026-01-01T02:30+02:00", "2026-01-01T02:30:15", "2025-12-31T20:00-0430"}) {
    const Result<Moment> moment = parse_time(text);
    ASSERT_TRUE(moment) << text;
    EXPECT_EQ(*parse_time(text_of(*moment)), *moment) << text_of(*moment);
  }
  EXPECT_EQ(text_of(*parse_time("2026-01-01T02:30+02:00")), "2026-01-01T00:30:00Z");
  EXPECT_EQ(days_of(*parse_time("2000-01-01T12:00")), 0);
}

}  // namespace
}  // namespace citykiln::sky
