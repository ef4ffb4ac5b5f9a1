#include "compiler/ground/water/water_height.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compiler/ground/plan.h"
#include "compiler/ground/water/plan_water_heights.h"
#include "compiler/roads/trim.h"
#include "tests/compiler/ground/water/made_water.h"

namespace citykiln::ground {
namespace {

using map::LandCoverClass;

constexpr Box2 kAll{{0, 0}, {4096, 4096}};

// A river 300 m wide with a bend and a side arm, a ditch beside it, and a lake it runs through.
Waters made_waters() {
  const map::Heightfield land = made_land([](Vec2 p) { return 20 + 0.01 * p.y; });
  const Ring banks = {{850, 4000}, {850, 2000}, {1450, 100}, {1750, 200}, {1150, 2050}, {1150, 4000}};
  std::vector<roads::Strip> streams = {made_stream(2, {{1000, 4000}, {1000, 2025}, {1600, 150}}, 12),
                                       made_stream(3, {{1900, 3000}, {1300, 2500}, {1000, 2025}}, 6),
                                       made_stream(4, {{1180, 3900}, {1180, 2600}}, 2)};
  Report report;
  return plan_water_heights({made_water(1, LandCoverClass::kRiver, banks),
                             made_water(5, LandCoverClass::kLake, made_shore({3000, 1000}, 300))},
                            std::move(streams), {}, land, report);
}

double profile_m(const roads::Strip& stream, double at_m) { return knot_at(stream.profile, at_m).z_m; }

TEST(WaterHeight, OnAnAxisIsItsProfiles) {
  const Waters waters = made_waters();
  const WaterIndex index = index_waters(waters.surfaces, waters.streams, kAll);
  for (const double at_m : {100.0, 700.5, 1900.0, 1975.0})
    EXPECT_NEAR(water_m(index, {1000, 4000 - at_m}).value(), profile_m(waters.streams[0], at_m), 1e-6);
}

TEST(WaterHeight, WithinAndBesideALakeIsItsLevel) {
  const Waters waters = made_waters();
  const WaterIndex index = index_waters(waters.surfaces, waters.streams, kAll);
  for (const Vec2 p : {Vec2{3000, 1000}, Vec2{3300, 1000}, Vec2{3310, 1100}, Vec2{2700, 700}})
    EXPECT_EQ(water_m(index, p), waters.surfaces[1].level_m);
  EXPECT_FALSE(water_m(index, {3000 + 300 + kStandingInfluence_m + 1, 1000}).has_value());
}

TEST(WaterHeight, IsKnownAllOverARiversAreaAndWithoutSteps) {
  const Waters waters = made_waters();
  const WaterIndex index = index_waters(waters.surfaces, waters.streams, kAll);
  for (double y = 2100; y <= 3900; y += 37) {
    double before_m = water_m(index, {850, y}).value();
    for (double x = 850; x <= 1150; x += 0.25) {
      const auto here_m = water_m(index, {x, y});
      ASSERT_TRUE(here_m.has_value()) << x << " " << y;
      ASSERT_NEAR(*here_m, before_m, 0.02) << x << " " << y;
      before_m = *here_m;
    }
  }
}

TEST(WaterHeight, ADitchBesideAWideRiverKeepsItsOwn) {
  Waters waters = made_waters();
  for (Knot& knot : waters.streams[2].profile) knot.z_m += 5;
  const WaterIndex index = index_waters(waters.surfaces, waters.streams, kAll);
  EXPECT_NEAR(water_m(index, {1181, 3000}).value(), profile_m(waters.streams[2], 900), 0.01);
}

TEST(WaterHeight, TilesFindTheSameBytesFromTheirOwnRecipes) {
  const Waters waters = made_waters();
  const WaterIndex whole = index_waters(waters.surfaces, waters.streams, kAll);
  int known = 0;
  for (double x0 = 768; x0 < 1800; x0 += 128)
    for (double y0 = 128; y0 < 4000; y0 += 384) {
      const Box2 tile{{x0, y0}, {x0 + 128, y0 + 128}};
      std::vector<LandCoverPolygon> surfaces;
      for (const LandCoverPolygon& s : waters.surfaces) surfaces.push_back(trimmed_to(s, tile.widened(48)));
      std::vector<roads::Strip> streams;
      for (const roads::Strip& s : waters.streams)
        for (roads::Strip& run : roads::trimmed_to(s, tile, 48)) streams.push_back(std::move(run));
      const WaterIndex index = index_waters(surfaces, streams, tile);
      for (double x = x0; x <= x0 + 128; x += 16)
        for (double y = y0; y <= y0 + 128; y += 16) {
          EXPECT_EQ(water_m(index, {x, y}), water_m(whole, {x, y}));
          known += water_m(whole, {x, y}).has_value();
        }
    }
  EXPECT_GT(known, 100);
}

}  // namespace
}  // namespace citykiln::ground
