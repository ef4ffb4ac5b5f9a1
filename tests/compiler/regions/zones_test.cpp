#include "compiler/regions/zones.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compiler/map/locate.h"
#include "compiler/map/plane/plane.h"

namespace citykiln::regions {
namespace {

constexpr source::LonLatBox kGermany{5.87, 47.27, 15.04, 55.06};

TEST(Zones, CoverTheExtentAndShareSides) {
  const std::vector<Zone> zones = zones_of(kGermany);
  ASSERT_EQ(zones.size(), 4u * 5u);
  EXPECT_EQ(zones.front().box.west, kGermany.west);
  EXPECT_EQ(zones.back().box.north, kGermany.north);
  EXPECT_EQ(zones[0].box.north, zones[1].box.south);
  EXPECT_EQ(zones[0].box.east, zones[5].box.west);
  EXPECT_EQ(zones_of({7, 50, 7.5, 50.5}).size(), 1u);
}

TEST(Zones, StateTheirScaleError) {
  for (const Zone& zone : zones_of(kGermany)) EXPECT_LT(scale_error(zone), 125e-6);
  EXPECT_NEAR(scale_error(zones_of({-0.2238, -0.1, 0.2238, 0.1}).front()), 7.7e-6, 0.1e-6);
}

// Metres on the ground between two places that are near each other.
double apart_m(LonLat a, LonLat b) {
  const double north_m = (a.lat_deg - b.lat_deg) * 111200,
               east_m = (a.lon_deg - b.lon_deg) * 111300 * std::cos(a.lat_deg * 0.0174533);
  return std::hypot(north_m, east_m);
}

TEST(Zones, TheSamePlaceAgreesInThePlanesOfNeighbours) {
  const std::vector<Zone> zones = zones_of(kGermany);
  const map::Plane west(map::default_origin(zones[1].box)), east(map::default_origin(zones[6].box));
  const double side_deg = zones[1].box.east;
  double farthest_m = 0;
  for (int i = 0; i <= 1000; ++i) {
    const double lat = zones[1].box.south + (zones[1].box.north - zones[1].box.south) * i / 1000;
    const source::Location place{static_cast<std::int32_t>(std::lround(side_deg * 1e7)),
                                 static_cast<std::int32_t>(std::lround(lat * 1e7))};
    farthest_m = std::max(
        farthest_m, apart_m(west.backward(west.snapped_forward(place)), east.backward(east.snapped_forward(place))));
  }
  EXPECT_LE(farthest_m, kZoneAgreement_m);
  EXPECT_GT(farthest_m, kZoneAgreement_m / 4);
}

}  // namespace
}  // namespace citykiln::regions
