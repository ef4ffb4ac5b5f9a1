#include "compiler/ground/levelling/airports.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compiler/map/plane/smooth_land.h"
#include "tests/compiler/ground/profiles/made_network.h"

namespace citykiln::ground {
namespace {

using map::LandCoverClass;

map::Track runway(std::int64_t id, Polyline axis, double width_m) {
  map::Track track = ground::track(id, std::move(axis), LandCoverClass::kRunway);
  track.section = {{{map::LaneKind::kDriving, map::LaneDirection::kBoth, width_m}}, width_m / 2};
  return track;
}

map::AreaFeature area_of(std::int64_t id, LandCoverClass surface, Ring ring) {
  map::AreaFeature area;
  area.id = {{OsmType::kWay, id}, 0}, area.surface = surface, area.polygon.outer = std::move(ring);
  area.area_m2 = area_m2(area.polygon);
  return area;
}

// A runway of 2 km, a taxiway beside it, an apron, and the stub that joins them.
map::Features airport() {
  map::Features features;
  features.tracks = {runway(1, {{-1000, 0}, {1000, 0}}, 45), runway(2, {{-1000, 150}, {1000, 150}}, 15),
                     runway(3, {{0, 0}, {0, 150}}, 15)};
  features.areas = {area_of(4, LandCoverClass::kApron, {{-200, 180}, {200, 180}, {200, 350}, {-200, 350}})};
  return features;
}

// Noise like that of trees, houses and radar on a slope of 0.4 %.
map::Heightfield noisy_land(double step_m, double noise_m) {
  const RandomSequence draw(9, StableId{1}, "noise");
  std::uint32_t next = 0;
  return field_from([&](double x, double) { return 40 + 0.004 * x + draw.between(-noise_m, noise_m, next++); }, 2048,
                    step_m);
}

double largest_slope(const map::Heightfield& field, const Box2& box, double over_m) {
  double largest = 0;
  for (double x = box.min.x; x + over_m <= box.max.x; x += over_m)
    for (double y = box.min.y; y + over_m <= box.max.y; y += over_m) {
      const double z_m = height_m_at(field, {x, y});
      largest = std::max({largest, std::abs(height_m_at(field, {x + over_m, y}) - z_m) / over_m,
                          std::abs(height_m_at(field, {x, y + over_m}) - z_m) / over_m});
    }
  return largest;
}

TEST(Airports, AreEvenOnNoisyHeightmaps) {
  const map::Features features = airport();
  for (const double step_m : {8.0, 32.0, 64.0, 96.0}) {
    const map::Heightfield noisy = noisy_land(step_m, 15);
    const map::Heightfield land =
        with_level_airports(map::smooth_land(noisy, map::smooth_parts({step_m, step_m})), features);
    EXPECT_GT(largest_slope(noisy, {{-1000, -22}, {1000, 22}}, 20), 0.1) << step_m;
    EXPECT_LE(largest_slope(land, {{-1000, -22}, {1000, 22}}, 20), kAirportSlope + 0.002) << step_m;
    EXPECT_LE(largest_slope(land, {{-200, 0}, {200, 350}}, 20), kAirportSlope + 0.002) << step_m;
    for (const double x : {-900.0, 0.0, 900.0}) EXPECT_NEAR(height_m_at(land, {x, 0}), 40 + 0.004 * x, 4) << step_m;
  }
}

TEST(Airports, MeetTheLandInBanksOfOneInTen) {
  const map::Heightfield land =
      with_level_airports(field_from([](double, double y) { return y > 0 ? 20.0 : 0.0; }, 2048, 32), airport());
  EXPECT_LE(largest_slope(land, {{-1000, -500}, {1000, -50}}, 32), 0.14);
  EXPECT_LE(largest_slope(land, {{-1000, 400}, {1000, 900}}, 32), 0.14);
  EXPECT_EQ(height_m_at(land, {0, -1500}), 0);
  EXPECT_EQ(height_m_at(land, {0, 1500}), 20);
}

TEST(Airports, LeaveOtherLandAsItIs) {
  const map::Heightfield field = noisy_land(32, 15);
  EXPECT_EQ(with_level_airports(field, map::Features{}), field);
  map::Features helipad;
  helipad.areas = {area_of(1, LandCoverClass::kApron, {{0, 0}, {20, 0}, {20, 20}, {0, 20}})};
  EXPECT_EQ(with_level_airports(field, helipad), field);
  const map::Heightfield land = with_level_airports(field, airport());
  EXPECT_EQ(height_m_at(land, {0, -1800}), height_m_at(field, {0, -1800}));
}

}  // namespace
}  // namespace citykiln::ground
