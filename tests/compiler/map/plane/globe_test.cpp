#include "compiler/map/plane/globe.h"

#include <gtest/gtest.h>

#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/LocalCartesian.hpp>
#include <cmath>

namespace citykiln::map {
namespace {

const LonLat kGlobeOrigins[] = {{7.42, 43.73}, {-87.62, 41.88},  {174.87, -41.26}, {24.94, 60.17}, {1.52, 42.5},
                                {0, 0},        {-43.05, -22.91}, {179.99, 10},     {15.6, 78.2}};
const Vec3 kPlaces[] = {{0, 0, 0},           {100, -50, 12},    {5000, 7000, 350}, {-25000, 18000, 2900},
                        {60000, -80000, -3}, {-200000, 0, 100}, {0, 200000, 1000}, {-0.25, 0.125, 60}};

Vec3 by_geographiclib(LonLat origin, Vec3 p) {
  const LonLat place = Plane(origin).backward({p.x, p.y});
  const GeographicLib::LocalCartesian local(origin.lat_deg, origin.lon_deg, 0);
  Vec3 at;
  local.Forward(place.lat_deg, place.lon_deg, p.z, at.x, at.y, at.z);
  return at;
}

void expect_near(Vec3 a, Vec3 b, double most) {
  EXPECT_NEAR(a.x, b.x, most);
  EXPECT_NEAR(a.y, b.y, most);
  EXPECT_NEAR(a.z, b.z, most);
}

TEST(Globe, PositionsAreThoseOfGeographicLib) {
  for (const LonLat origin : kGlobeOrigins) {
    const Globe globe(origin);
    for (const Vec3 p : kPlaces) expect_near(globe.at(p).at, by_geographiclib(origin, p), 1e-6);
  }
}

TEST(Globe, TheFrameStandsWhereGeographicLibSays) {
  for (const LonLat origin : kGlobeOrigins) {
    const auto m = Globe(origin).to_earth();
    for (const Vec3 p : kPlaces) {
      const Vec3 at = by_geographiclib(origin, p);
      Vec3 earth, found;
      const LonLat place = Plane(origin).backward({p.x, p.y});
      GeographicLib::Geocentric::WGS84().Forward(place.lat_deg, place.lon_deg, p.z, earth.x, earth.y, earth.z);
      found.x = m[0] * at.x + m[4] * at.y + m[8] * at.z + m[12];
      found.y = m[1] * at.x + m[5] * at.y + m[9] * at.z + m[13];
      found.z = m[2] * at.x + m[6] * at.y + m[10] * at.z + m[14];
      expect_near(found, earth, 1e-6);
    }
  }
}

TEST(Globe, AxesAreTheDirectionsInWhichPositionsMove) {
  for (const LonLat origin : kGlobeOrigins) {
    const Globe globe(origin);
    for (const Vec3 p : kPlaces) {
      const BentPoint here = globe.at(p);
      const auto along = [&](Vec3 step) { return unit(globe.at(p + step).at - globe.at(p - step).at); };
      expect_near(here.east, along({10, 0, 0}), 2e-7);
      expect_near(here.north, along({0, 10, 0}), 2e-7);
      expect_near(here.up, along({0, 0, 10}), 2e-7);
      expect_near(cross(here.east, here.north), here.up, 1e-12);
    }
  }
}

TEST(Globe, LinesAreNoFartherFromTheirChordsThanTheSag) {
  for (const LonLat origin : kGlobeOrigins) {
    const Globe globe(origin);
    for (const Vec3 p : kPlaces)
      for (const Vec3 step :
           {Vec3{1000, 0, 0}, Vec3{0, 1000, 0}, Vec3{700, 700, 0}, Vec3{800, 100, 600}, Vec3{20, 5, 900}}) {
        const Vec3 chord = (globe.at(p - step).at + globe.at(p + step).at) * 0.5;
        EXPECT_LE(length(globe.at(p).at - chord), sag_m(2 * length(step)) * (1 + 1e-3));
        if (step.z == 0) {
          EXPECT_GT(length(globe.at(p).at - chord), 0.8 * sag_m(2 * length(step)));
        }
      }
  }
  EXPECT_NEAR(length_with_sag_m(sag_m(321)), 321, 1e-9);
}

}  // namespace
}  // namespace citykiln::map
