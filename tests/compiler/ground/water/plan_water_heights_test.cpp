#include "compiler/ground/water/plan_water_heights.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compiler/contract/random_sequence.h"
#include "compiler/ground/water/measure_waters.h"
#include "compiler/ground/water/river_depth.h"
#include "compiler/ground/water/river_heights.h"
#include "compiler/ground/water/standing_water.h"
#include "tests/compiler/ground/water/made_water.h"

namespace citykiln::ground {
namespace {

using map::LandCoverClass;

std::size_t count_of(const Report& report, Code code) {
  return static_cast<std::size_t>(std::ranges::count(report.diagnoses(), code, &Diagnosis::code));
}

double largest(const Report& report, Code code) {
  double size = 0;
  for (const Diagnosis& d : report.diagnoses())
    if (d.code == code) size = std::max(size, d.size);
  return size;
}

// Rough terrain that falls to the south.
map::Heightfield rough_land(std::uint64_t seed, double fall, double rough_m) {
  const RandomSequence draw(seed, StableId{7}, "land");
  return made_land([&](Vec2 p) {
    const auto index = static_cast<std::uint32_t>(p.x / 32 * 129 + p.y / 32);
    return 100 + p.y * fall + draw.between(-rough_m, rough_m, index);
  });
}

// Lines between points of a common lattice, in any direction: with junctions, forks and cycles.
std::vector<roads::Strip> random_network(std::uint64_t seed, int count) {
  const RandomSequence draw(seed, StableId{8}, "streams");
  std::vector<roads::Strip> streams;
  std::uint32_t index = 0;
  for (int s = 0; s < count; ++s) {
    Polyline axis;
    const auto points = 2 + draw.below(4, index++);
    while (axis.size() < points) {
      const Vec2 p{300.125 + 500.5 * draw.below(8, index), 300 + 499.25 * draw.below(8, index + 1)};
      index += 2;
      if (axis.empty() || axis.back() != p) axis.push_back(p);
    }
    streams.push_back(made_stream(s + 1, axis));
  }
  return streams;
}

std::vector<LandCoverPolygon> random_lakes(std::uint64_t seed, int count) {
  const RandomSequence draw(seed, StableId{9}, "lakes");
  std::vector<LandCoverPolygon> lakes;
  for (int i = 0; i < count; ++i) {
    const auto index = static_cast<std::uint32_t>(3 * i);
    const Vec2 centre = snapped(Vec2{draw.between(300, 3700, index), draw.between(300, 3700, index + 1)});
    const LandCoverClass surface = i == 0 ? LandCoverClass::kSea : LandCoverClass::kLake;
    lakes.push_back(made_water(1000 + i, surface, made_shore(centre, 16 + 16 * draw.below(16, index + 2))));
  }
  return lakes;
}

// The streams that did not stay on the terrain.
std::vector<roads::Strip> with_profile(std::vector<roads::Strip> streams) {
  std::erase_if(streams, [](const roads::Strip& stream) { return stream.profile.empty(); });
  return streams;
}

TEST(PlanWaterHeights, RiversNeverRiseInAnyNetwork) {
  std::size_t streams = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const map::Heightfield land = rough_land(seed, seed % 3 * 0.03, 5.0 * static_cast<double>(seed % 5));
    Report report;
    const Waters waters = plan_water_heights(random_lakes(seed, static_cast<int>(seed % 7)),
                                             random_network(seed, 3 + static_cast<int>(seed % 30)), {}, land, report);
    const WaterMeasures measures = measure_waters(waters.surfaces, with_profile(waters.streams), land);
    streams += measures.streams;
    EXPECT_EQ(measures.streams_that_rise, 0u) << seed << ": " << measures.largest_rise_m;
    for (const LandCoverPolygon& s : waters.surfaces)
      if (s.surface == LandCoverClass::kSea) {
        EXPECT_EQ(s.level_m, 0);
      }
  }
  EXPECT_GT(streams, 100u);
}

TEST(PlanWaterHeights, RiversHaveALakesLevelWithinIt) {
  const map::Heightfield land = rough_land(3, 0.02, 3);
  Report report;
  const Waters waters =
      plan_water_heights({made_water(1, LandCoverClass::kLake, made_shore({2000, 2000}, 200))},
                         {made_stream(2, {{2010, 3500}, {2000, 2100}, {1990, 1000}})}, {}, land, report);
  const double level_m = waters.surfaces[0].level_m.value();
  const Profile& profile = waters.streams[0].profile;
  for (const double y : {2200.0, 2100.0, 1900.0, 1800.0}) {
    double at_m = 0;
    at_m = y >= 2100 ? (3500 - y) * std::sqrt(1 + 100.0 / (1400 * 1400))
                     : distance({2010, 3500}, {2000, 2100}) + (2100 - y) * std::sqrt(1 + 100.0 / (1100 * 1100));
    EXPECT_NEAR(knot_at(profile, at_m).z_m, level_m, 1e-6) << y;
  }
  EXPECT_GT(profile.front().z_m, level_m + 10);
  EXPECT_LT(profile.back().z_m, level_m - 10);
}

// Whether a stream stayed on the terrain and was reported.
bool stays_on_land(const Waters& waters, std::size_t stream, const Report& report) {
  const std::size_t found = count_of(report, Code::kWaterwayRises) + count_of(report, Code::kWaterwayOffLake) +
                            count_of(report, Code::kWaterwayOffNeighbours);
  return waters.streams[stream].profile.empty() && found > 0;
}

TEST(PlanWaterHeights, ABrookIsNotDugDownToALakeWhoseLevelIsWrong) {
  // level land, and a lake drawn over a gorge 25 m deep: the brook from it would lie in a trench of its depth
  const map::Heightfield land = made_land([](Vec2 p) {
    return distance(p, {2000, 3000}) < 250 ? 75.0 : 100 - 0.001 * (3000 - p.y);
  });
  Report report;
  const Waters waters = plan_water_heights({made_water(1, LandCoverClass::kLake, made_shore({2000, 3000}, 200))},
                                           {made_stream(2, {{2000, 2900}, {2000, 1500}}, 1)}, {}, land, report);
  EXPECT_TRUE(stays_on_land(waters, 0, report));
}

TEST(PlanWaterHeights, AStreamKeepsToItsDepthOnARidgeAndBesideItsValley) {
  // a ridge 8 m high that falls to the south, a valley of 30 m beside the stream's mapped course
  const auto slope = [](Vec2 p) { return 100 + 0.03 * p.y; };
  const map::Heightfield ridge =
      made_land([&](Vec2 p) { return slope(p) + std::max(0.0, 8 - std::abs(p.x - 2000) / 10); });
  const map::Heightfield valley =
      made_land([&](Vec2 p) { return slope(p) - std::max(0.0, 30 - std::abs(p.x - 2150) / 5); });
  for (const map::Heightfield& land : {ridge, valley}) {
    Report report;
    const Waters waters =
        plan_water_heights({}, {made_stream(1, {{2000, 3500}, {2040, 2000}, {2000, 500}})}, {}, land, report);
    ASSERT_FALSE(waters.streams[0].profile.empty());
    const WaterMeasures measures = measure_waters({}, waters.streams, land);
    EXPECT_EQ(measures.streams_that_rise, 0u);
    EXPECT_LE(measures.deepest_below_land_m, kMaxStreamDepth_m);
    EXPECT_LE(measures.highest_above_land_m, kMaxStreamDepth_m);
  }
}

TEST(PlanWaterHeights, NoWatercourseLiesTooDeepForLongerThanNoise) {
  // steps of 20 m and trees; the floor of a valley may lie beside the line
  constexpr double deepest_m = kMaxDitchDepth_m + kMaxAside_m + 0.1;
  std::size_t with_heights = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const map::Heightfield land = rough_land(seed, 0.05, seed % 2 == 0 ? 20 : 6);
    Report report;
    const Waters waters =
        plan_water_heights({}, {made_stream(1, {{2000, 3500}, {2300, 2000}, {2000, 500}}, 1)}, {}, land, report);
    const roads::Strip& stream = waters.streams[0];
    EXPECT_TRUE(!stream.profile.empty() || stays_on_land(waters, 0, report));
    if (stream.profile.empty()) continue;
    ++with_heights;
    const std::vector<double> along = roads::distances_along(stream.axis, 0);
    double run_m = 0;
    for (double at_m = 0; at_m < along.back(); at_m += 4) {
      const std::size_t i = at_m < along[1] ? 0 : 1;
      const Vec2 p =
          stream.axis[i] + (stream.axis[i + 1] - stream.axis[i]) * ((at_m - along[i]) / (along[i + 1] - along[i]));
      run_m = height_m_at(land, p) - knot_at(stream.profile, at_m).z_m > deepest_m ? run_m + 4 : 0;
      EXPECT_LE(run_m, (kSustained + 1) * land.longer_sample_step_m()) << seed;
    }
  }
  EXPECT_GT(with_heights, 0u);
}

TEST(PlanWaterHeights, OrderDoesNotMatter) {
  const map::Heightfield land = rough_land(5, 0.01, 6);
  std::vector<LandCoverPolygon> lakes = random_lakes(5, 6);
  std::vector<roads::Strip> streams = random_network(5, 25);
  Report report, other;
  const Waters first = plan_water_heights(lakes, streams, {}, land, report);
  std::ranges::reverse(lakes);
  std::ranges::reverse(streams);
  Waters second = plan_water_heights(lakes, streams, {}, land, other);
  std::ranges::reverse(second.surfaces);
  EXPECT_TRUE(first.surfaces == second.surfaces);
  EXPECT_TRUE(first.streams == second.streams);
}

TEST(PlanWaterHeights, NoLakeStandsAboveMostOfItsShore) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const map::Heightfield land = rough_land(seed, 0.05, 20);
    Report report;
    const Waters waters = plan_water_heights(random_lakes(seed + 100, 4), {}, {}, land, report);
    EXPECT_GT(std::ranges::count(waters.surfaces, LandCoverClass::kLake, &LandCoverPolygon::surface), 0);
    for (const LandCoverPolygon& lake : waters.surfaces) {
      if (lake.surface != LandCoverClass::kLake) continue;
      double below = 0, all = 0;
      for (const Vec2 p : lake.rings[0]) ++all, below += height_m_at(land, p) < *lake.level_m;
      EXPECT_LE(below / all, 0.45) << seed;
    }
  }
}

TEST(PlanWaterHeights, TreesSpikesAndPitsOnAShoreDoNotMoveALake) {
  const auto plain = [](Vec2 p) { return 500 + 0.02 * std::abs(p.x - 2000) + 0.02 * std::abs(p.y - 2000); };
  const std::vector<LandCoverPolygon> lake = {made_water(1, LandCoverClass::kLake, made_shore({2000, 2000}, 400))};
  Report report;
  const double level_m = *plan_water_heights(lake, {}, {}, made_land(plain), report).surfaces[0].level_m;
  const auto rough = [&](Vec2 p) {
    if (p.x == 1600 && p.y == 1984) return 900.0;          // a summit
    if (p.x == 2016 && p.y == 2400) return -32768.0 / 64;  // a void that was not filled
    return plain(p) + (p.x > 2300 ? 25 : 0);               // trees on the east shore
  };
  EXPECT_NEAR(*plan_water_heights(lake, {}, {}, made_land(rough), report).surfaces[0].level_m, level_m, 1.5);
}

TEST(PlanWaterHeights, ANodeInTheSkyIsLeftOutOfItsLake) {
  const map::Heightfield land = made_land([](Vec2 p) { return 200 + 0.3 * p.y; });
  Ring shore = made_shore({2000, 2000}, 64);
  const Ring whole = shore;
  shore.insert(shore.begin() + 24, {2003, 300});
  Report report, other;
  const Waters spiked = plan_water_heights({made_water(1, LandCoverClass::kLake, shore)}, {}, {}, land, report);
  const Waters plain = plan_water_heights({made_water(1, LandCoverClass::kLake, whole)}, {}, {}, land, other);
  EXPECT_EQ(count_of(report, Code::kShoreSpike), 1u);
  EXPECT_EQ(spiked.surfaces[0].rings, plain.surfaces[0].rings);
  EXPECT_NEAR(*spiked.surfaces[0].level_m, *plain.surfaces[0].level_m, 2);
}

TEST(PlanWaterHeights, WatersThatShareABorderShareALevelUnlessADamPartsThem) {
  const Ring west = {{1000, 1000}, {1500, 1000}, {1500, 1500}, {1000, 1500}};
  const Ring east = {{1500, 1000}, {2000, 1000}, {2000, 1500}, {1500, 1500}};
  const std::vector<LandCoverPolygon> both = {made_water(1, LandCoverClass::kLake, west),
                                              made_water(2, LandCoverClass::kBasin, east)};
  Report report;
  const Waters near = plan_water_heights(both, {}, {}, made_land([](Vec2 p) { return 50 + p.x / 200; }), report);
  EXPECT_EQ(near.surfaces[0].level_m, near.surfaces[1].level_m);
  const Waters parted =
      plan_water_heights(both, {}, {}, made_land([](Vec2 p) { return p.x < 1500 ? 100.0 : 50.0; }), report);
  EXPECT_GT(*parted.surfaces[0].level_m, *parted.surfaces[1].level_m + kDam_m);
}

TEST(PlanWaterHeights, DocksAtTheSeaAreAtItsLevel) {
  const Ring sea = {{0, 0}, {2000, 0}, {2000, 1500}, {0, 1500}},
             dock = {{2000, 0}, {2500, 0}, {2500, 1500}, {2000, 1500}};
  const auto level_of_dock = [&](double quay_m) {
    Report report;
    const std::vector<LandCoverPolygon> both = {made_water(1, LandCoverClass::kSea, sea),
                                                made_water(2, LandCoverClass::kDock, dock)};
    return *plan_water_heights(both, {}, {}, made_land([&](Vec2 p) { return p.x > 1990 ? quay_m : 1; }), report)
                .surfaces[1]
                .level_m;
  };
  EXPECT_EQ(level_of_dock(5), 0);
  EXPECT_EQ(level_of_dock(40), 40);
}

TEST(PlanWaterHeights, ARiverMappedUphillIsTurned) {
  const map::Heightfield land = rough_land(4, 0.05, 2);
  Report report;
  const Waters waters =
      plan_water_heights({}, {made_stream(1, {{1000, 500}, {1100, 1800}, {1000, 3000}})}, {}, land, report);
  EXPECT_EQ(count_of(report, Code::kWaterwayReversed), 1u);
  EXPECT_GT(largest(report, Code::kWaterwayReversed), 50);
  EXPECT_EQ(waters.streams[0].axis.front(), (Vec2{1000, 3000}));
  EXPECT_EQ(measure_waters(waters.surfaces, waters.streams, land).streams_that_rise, 0u);
  EXPECT_EQ(count_of(report, Code::kRiverOffTerrain), 0u);
}

TEST(PlanWaterHeights, ARiverThatRunsInACircleLiesLevel) {
  Report report;
  const Waters moat = plan_water_heights({}, {made_stream(1, {{1000, 1000}, {1100, 1000}, {1100, 1100}, {1000, 1000}})},
                                         {}, rough_land(4, 0, 2), report);
  EXPECT_EQ(moat.streams[0].profile.size(), 1u);
  EXPECT_EQ(count_of(report, Code::kWaterwayCycle), 1u);
}

TEST(PlanWaterHeights, APitInTheLandSinksNoRiverForLong) {
  const auto even = [](Vec2 p) { return 100 + 0.01 * p.y; };
  const auto pitted = [&](Vec2 p) { return even(p) - (p.x == 1600 && p.y == 2016 ? 80 : 0); };
  const std::vector<roads::Strip> river = {made_stream(1, {{1600, 3900}, {1600, 100}})};
  Report report;
  const Profile plain = plan_water_heights({}, river, {}, made_land(even), report).streams[0].profile;
  const Profile sunk = plan_water_heights({}, river, {}, made_land(pitted), report).streams[0].profile;
  ASSERT_FALSE(plain.empty() || sunk.empty());
  for (double at_m = 0; at_m <= 3800; at_m += 10) {
    const double off_m = std::abs(knot_at(plain, at_m).z_m - knot_at(sunk, at_m).z_m);
    EXPECT_LE(off_m, kAboveCost * 64 * 0.01 + 0.1) << at_m;
    if (std::abs(at_m - 1884) > 700) {
      EXPECT_LE(off_m, 0.1) << at_m;
    }
  }
}

TEST(PlanWaterHeights, AnEvenFallHasNoSteps) {
  Report report;
  const Waters waters = plan_water_heights({}, {made_stream(1, {{1010, 3900}, {1300, 100}})}, {},
                                           made_land([](Vec2 p) { return 100 + 0.03125 * p.y; }), report);
  EXPECT_LE(waters.streams[0].profile.size(), 3u);
  // and on rough terrain no more than the roughness between neighbouring knots
  const map::Heightfield rough = rough_land(11, 0.05, 3);
  const Profile p =
      plan_water_heights({}, {made_stream(1, {{1010, 3900}, {1300, 100}})}, {}, rough, report).streams[0].profile;
  for (std::size_t i = 0; i + 1 < p.size(); ++i)
    EXPECT_LT((p[i].z_m - p[i + 1].z_m) / (p[i + 1].at_m - p[i].at_m), 0.2);
}

// A valley with sides of 1 : 2 that falls to the south, winds, and is noisy.
map::Heightfield winding_valley(std::uint64_t seed) {
  const RandomSequence draw(seed, StableId{7}, "valley");
  return made_land([&](Vec2 p) {
    const double floor_x = 2000 + 60 * std::sin(p.y / 250);
    const auto index = static_cast<std::uint32_t>(p.x / 32 * 129 + p.y / 32);
    return 300 + 0.04 * p.y + 0.5 * std::abs(p.x - floor_x) + draw.between(-2, 2, index);
  });
}

TEST(PlanWaterHeights, AStreamBesideTheValleysFloorRunsAtItsHeight) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const map::Heightfield land = winding_valley(seed);
    Polyline axis;  // up to 15 m beside the floor
    const RandomSequence draw(seed, StableId{3}, "map");
    for (std::uint32_t i = 0; i <= 60; ++i) {
      const double y = 3500 - 50.0 * i;
      axis.push_back(snapped(Vec2{2000 + 60 * std::sin(y / 250) + draw.between(-15, 15, i), y}));
    }
    Report report;
    const Waters waters = plan_water_heights({}, {made_stream(1, axis)}, {}, land, report);
    ASSERT_FALSE(waters.streams[0].profile.empty());
    EXPECT_TRUE(report.diagnoses().empty());
    const WaterMeasures measures = measure_waters({}, waters.streams, land);
    EXPECT_EQ(measures.streams_that_rise, 0u);
    EXPECT_LE(measures.deepest_below_land_m, kMaxAside_m);
    EXPECT_LE(measures.highest_above_land_m, 6);
  }
}

TEST(PlanWaterHeights, AStreamOverARidgeDoesNotMoveThoseThatItMeets) {
  // streams down a slope to the south; one leads over a ridge of 80 m between two others
  const auto slope = [](Vec2 p) { return 300 + 0.05 * p.y; };
  const map::Heightfield land =
      made_land([&](Vec2 p) { return slope(p) + std::max(0.0, 80 - std::abs(p.x - 2000) / 4); });
  const std::vector<roads::Strip> outer = {made_stream(1, {{1600, 3900}, {1600, 2100}, {1600, 100}}),
                                           made_stream(2, {{2400, 3900}, {2400, 1900}, {2400, 100}})};
  std::vector<roads::Strip> all = outer;
  all.push_back(made_stream(3, {{1600, 2100}, {2400, 1900}}));
  Report report, other;
  const Waters with = plan_water_heights({}, all, {}, land, report);
  const Waters without = plan_water_heights({}, outer, {}, land, other);
  EXPECT_TRUE(with.streams[2].profile.empty());
  EXPECT_EQ(count_of(report, Code::kWaterwayRises), 1u);
  EXPECT_GT(largest(report, Code::kWaterwayRises), 20);
  for (const std::size_t i : {0u, 1u})
    for (double at_m = 0; at_m <= 3800; at_m += 50)
      EXPECT_NEAR(knot_at(with.streams[i].profile, at_m).z_m, knot_at(without.streams[i].profile, at_m).z_m, 0.5);
}

TEST(PlanWaterHeights, AnArmMappedUphillDoesNotMakeItsRiverLevel) {
  // an arm leads back to where it left the river, 75 m up
  const map::Heightfield land = made_land([](Vec2 p) { return 100 + 0.05 * p.y; });
  Report report;
  const Waters waters = plan_water_heights(
      {},
      {made_stream(1, {{2000, 3900}, {2000, 3000}}), made_stream(2, {{2000, 3000}, {2000, 1500}}),
       made_stream(3, {{2000, 1500}, {2000, 100}}), made_stream(4, {{2000, 1500}, {2300, 2200}, {2000, 3000}})},
      {}, land, report);
  const WaterMeasures measures = measure_waters({}, with_profile(waters.streams), land);
  EXPECT_LE(measures.deepest_below_land_m, 2);
  EXPECT_LE(measures.highest_above_land_m, 2);
  EXPECT_EQ(measures.streams_that_rise, 0u);
  EXPECT_EQ(count_of(report, Code::kWaterwayCycle), 0u);
}

TEST(PlanWaterHeights, StreamsJoinAndEndInALake) {
  const map::Heightfield land = rough_land(12, 0.04, 2);
  Report report;
  const Waters waters =
      plan_water_heights({made_water(9, LandCoverClass::kLake, made_shore({2000, 800}, 200))},
                         {made_stream(1, {{1000, 3500}, {2000, 2000}}), made_stream(2, {{3000, 3500}, {2000, 2000}}),
                          made_stream(3, {{2000, 2000}, {2000, 900}})},
                         {}, land, report);
  const auto end_m = [&](std::size_t i) { return waters.streams[i].profile.back().z_m; };
  for (const roads::Strip& stream : waters.streams) ASSERT_FALSE(stream.profile.empty());
  EXPECT_EQ(end_m(0), waters.streams[2].profile.front().z_m);
  EXPECT_EQ(end_m(1), waters.streams[2].profile.front().z_m);
  EXPECT_NEAR(end_m(2), *waters.surfaces[0].level_m, 1e-6);
}

TEST(PlanWaterHeights, AStreamInPartsAndItsCulvertAreTurnedTogether) {
  // mapped up a slope that rises by 9 m along each part, in parts that are too short to be sure of one
  const map::Heightfield land = made_land([](Vec2 p) { return 100 + 0.03 * p.y; });
  Report report;
  const Waters waters = plan_water_heights(
      {}, {made_stream(1, {{1000, 1000}, {1000, 1300}}), made_stream(2, {{1000, 1330}, {1000, 1630}})},
      std::vector<Polyline>{{{1000, 1300}, {1000, 1330}}}, land, report);
  EXPECT_EQ(count_of(report, Code::kWaterwayReversed), 2u);
  EXPECT_EQ(waters.streams[1].axis.front(), (Vec2{1000, 1630}));
  EXPECT_GE(waters.streams[1].profile.back().z_m, waters.streams[0].profile.front().z_m);
  EXPECT_NEAR(waters.streams[0].profile.back().z_m, 130, 1);
}

TEST(PlanWaterHeights, CulvertsPassTheirHeightOn) {
  const map::Heightfield land = made_land([](Vec2 p) { return p.y > 2000 ? 50.0 : 57.0; });
  const std::vector<roads::Strip> two = {made_stream(1, {{1000, 3000}, {1000, 2100}}),
                                         made_stream(2, {{1000, 1900}, {1000, 500}})};
  const std::vector<Polyline> culvert = {{{1000, 2100}, {1000, 1900}}};
  Report report;
  const Waters waters = plan_water_heights({}, two, culvert, land, report);
  EXPECT_GE(waters.streams[0].profile.back().z_m, waters.streams[1].profile.front().z_m);
}

TEST(PlanWaterHeights, LandAwayFromWaterDoesNotMatter) {
  const std::vector<LandCoverPolygon> lake = {made_water(1, LandCoverClass::kLake, made_shore({1000, 1000}, 200))};
  const std::vector<roads::Strip> river = {made_stream(2, {{1000, 3000}, {1010, 1800}, {1000, 1100}})};
  const auto even = [](Vec2 p) { return 100 + 0.01 * p.y; };
  const auto other = [&](Vec2 p) { return p.x > 1400 ? 700.0 : even(p); };
  Report report;
  const Waters a = plan_water_heights(lake, river, {}, made_land(even), report);
  const Waters b = plan_water_heights(lake, river, {}, made_land(other), report);
  EXPECT_TRUE(a.surfaces == b.surfaces);
  EXPECT_TRUE(a.streams == b.streams);
}

TEST(PlanWaterHeights, WithoutHeightsNothingIsWritten) {
  const std::vector<LandCoverPolygon> lakes = random_lakes(5, 6);
  const std::vector<roads::Strip> streams = random_network(5, 25);
  Report report;
  const Waters waters = plan_water_heights(lakes, streams, {}, made_land([](Vec2) { return 0; }), report);
  EXPECT_TRUE(waters.surfaces == lakes);
  EXPECT_TRUE(waters.streams == streams);
  EXPECT_TRUE(report.diagnoses().empty());
}

TEST(PlanWaterHeights, AreasWithoutAxisAreLevelOthersHaveTheReachOfTheirBanks) {
  const map::Heightfield land = rough_land(6, 0.002, 1);
  const Ring with = {{1000, 3900}, {900, 100}, {1300, 100}, {1400, 3900}},
             without = {{2000, 2000}, {2300, 2000}, {2300, 2400}};
  Report report;
  const Waters waters = plan_water_heights(
      {made_water(1, LandCoverClass::kRiver, with), made_water(2, LandCoverClass::kRiver, without)},
      {made_stream(3, {{1200, 4000}, {1100, 0}}), made_stream(4, {{3000, 4000}, {3000, 0}})}, {}, land, report);
  EXPECT_FALSE(waters.surfaces[0].level_m.has_value());
  EXPECT_TRUE(waters.surfaces[1].level_m.has_value());
  EXPECT_EQ(count_of(report, Code::kRiverAreaWithoutAxis), 1u);
  EXPECT_GE(waters.streams[0].influence_radius_m, 200);
  EXPECT_LE(waters.streams[0].influence_radius_m, 320);
  EXPECT_EQ(waters.streams[1].influence_radius_m, 0);
}

}  // namespace
}  // namespace citykiln::ground
