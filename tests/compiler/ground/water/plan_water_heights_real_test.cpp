// Real lakes and rivers.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "compiler/ground/water/measure_waters.h"
#include "compiler/ground/water/plan_water_heights.h"
#include "compiler/ground/water/standing_water.h"
#include "tests/compiler/ground/real_ground.h"
#include "tests/test_files.h"

namespace citykiln::ground {
namespace {

struct RealPlace {
  std::string map, dem;
  std::size_t least_streams, least_that_rose;
};

void PrintTo(const RealPlace& place, std::ostream* os) { *os << place.map; }

struct PlanWaterHeightsReal : testing::TestWithParam<RealPlace> {
  void SetUp() override {
    if (!std::filesystem::exists(real_data(GetParam().map))) GTEST_SKIP() << "no extracts in " << real_data();
  }

  RealGround read() {
    Report report;
    const std::string dem = GetParam().dem.empty() ? "" : real_data(GetParam().dem).string();
    auto ground = read_real_ground(real_data(GetParam().map), dem, report);
    if (ground) return std::move(*ground);
    ADD_FAILURE() << to_string(ground.error());
    return {};
  }
};

TEST_P(PlanWaterHeightsReal, NoRiverRises) {
  const RealGround ground = read();
  Report report;
  Waters waters = plan_water_heights(ground.surfaces, ground.streams, ground.covered, ground.heights, report);
  // where there is terrain, those without a profile stay on it and are reported
  if (!GetParam().dem.empty()) {
    std::erase_if(waters.streams, [](const roads::Strip& stream) { return stream.profile.empty(); });
    EXPECT_GE(waters.streams.size(), ground.streams.size() * 95 / 100);
  }
  const WaterMeasures before = measure_waters(ground.surfaces, ground.streams, ground.heights);
  const WaterMeasures after = measure_waters(waters.surfaces, waters.streams, ground.heights);
  EXPECT_GE(before.streams, GetParam().least_streams);
  EXPECT_GE(before.streams_that_rise, GetParam().least_that_rose);
  EXPECT_EQ(after.streams_that_rise, 0u) << after.largest_rise_m;
  fmt::print("{} streams, {} rose by up to {:.1f} m; {} standing; {:.1f} m below the land, {:.1f} m above\n",
             before.streams, before.streams_that_rise, before.largest_rise_m, after.standing,
             after.deepest_below_land_m, after.highest_above_land_m);
}

TEST_P(PlanWaterHeightsReal, LakesStandAtTheirShores) {
  const RealGround ground = read();
  Report report;
  const Waters waters = plan_water_heights(ground.surfaces, ground.streams, ground.covered, ground.heights, report);
  for (const LandCoverPolygon& lake : waters.surfaces) {
    if (!lake.level_m || lake.area_m2 < 20'000 || *lake.level_m == 0) continue;
    const Shore shore = shore_of(lake.rings, ground.heights);
    EXPECT_LE(*lake.level_m, shore.low_m + 2) << to_string(lake.id.osm);
    EXPECT_GE(*lake.level_m, shore.low_m - 5) << to_string(lake.id.osm);
  }
}

INSTANTIATE_TEST_SUITE_P(Places, PlanWaterHeightsReal,
                         testing::Values(RealPlace{"andorra/andorra-2023.osm.pbf", "andorra/N42E001.hgt", 500, 200},
                                         RealPlace{"andorra/andorra-2013.osm.gz", "andorra/N42E001.hgt", 100, 50},
                                         RealPlace{"monaco/monaco-2016-cadastre.osm.pbf", "monaco/N43E007.hgt", 10, 3},
                                         RealPlace{"monaco/monaco-2023.osm.pbf", "monaco/N43E007.hgt", 0, 0},
                                         RealPlace{"berlin/berlin-reinickendorf-2026.osm.pbf", "berlin/N52E013.hgt", 10,
                                                   5},
                                         RealPlace{"liechtenstein/liechtenstein-2015.osm.pbf", "", 100, 0},
                                         RealPlace{"neubrandenburg/neubrandenburg.osm.bz2", "", 100, 0}));

}  // namespace
}  // namespace citykiln::ground
