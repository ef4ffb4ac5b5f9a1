// Mouths of tunnels in flat land.
#include "compiler/ground/profiles/crossings/lower_mouths.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/ground/profiles/graph/grade_rules.h"
#include "compiler/ground/profiles/planned_spans.h"
#include "compiler/ground/profiles/smoothing/profile_knots.h"
#include "tests/compiler/ground/profiles/made_network.h"

namespace citykiln::ground {
namespace {

using map::LandCoverClass;
using map::Passage;

constexpr double kLand_m = 40;

map::Heightfield flat() {
  return field_from([](double, double) { return kLand_m; });
}

// A tunnel from x = -50 to 50 and a way that leads to each mouth, `run_m` long.
map::Features under_flat_land(LandCoverClass surface, double run_m) {
  map::Features f;
  f.extent = {{-1024, -1024}, {1024, 1024}};
  f.tracks = {track(1, {{-50 - run_m, 0}, {-50, 0}}, surface),
              track(2, {{-50, 0}, {50, 0}}, surface, Passage::kTunnel, -1),
              track(3, {{50, 0}, {50 + run_m, 0}}, surface)};
  return f;
}

double needed_m(LandCoverClass surface) { return bore_height_m(surface) + kBoreCover_m; }

GradedTerrain graded_by(const map::Features& features, const Profiles& profiles, const map::Heightfield& heights) {
  const PlannedSpans spans = planned_spans(features, profiles, heights);
  std::vector<roads::Road> bores = spans.bores;
  std::size_t off = 0;
  for (const map::Track& t : features.tracks) {
    if (!leaves_ground(t)) continue;
    roads::Road path = roads::road_of(t);
    path.profile = profiles.off_ground[off++];
    if (!has_profile(t.surface) && !enters_from_above(path, heights)) bores.push_back(std::move(path));
  }
  return grade_terrain(
      heights,
      {.roads = profiles.roads, .streams = {}, .surfaces = {}, .box = {{-900, -900}, {900, 900}}, .bores = bores});
}

// The highest land above the terrain within 15 m of a place.
double highest_rise_m(const GradedTerrain& graded, Vec2 mouth) {
  double most_m = 0;
  for (double x = -15; x <= 15; x += 0.5)
    for (double y = -15; y <= 15; y += 0.5)
      if (x * x + y * y <= 225) most_m = std::max(most_m, land_m(graded, mouth + Vec2{x, y}) - kLand_m);
  return most_m;
}

constexpr LandCoverClass kClasses[] = {LandCoverClass::kPrimaryRoad,   LandCoverClass::kResidentialRoad,
                                       LandCoverClass::kServiceRoad,   LandCoverClass::kRailway,
                                       LandCoverClass::kPavedFootPath, LandCoverClass::kSteps};

TEST(Mouths, NoGroundRisesAboveFlatLand) {
  for (const LandCoverClass surface : kClasses) {
    const map::Features f = under_flat_land(surface, 400);
    const Planned p = planned(f, flat());
    const GradedTerrain graded = graded_by(f, p.profiles, flat());
    EXPECT_EQ(graded.bores.roads.profiles.size(), 1u) << map::values_of(surface).priority;
    for (const Vec2 mouth : {Vec2{-50, 0}, Vec2{50, 0}}) EXPECT_LE(highest_rise_m(graded, mouth), 0.3);
  }
}

TEST(Mouths, ThePathGoesDownWithinItsLimit) {
  for (const LandCoverClass surface : kClasses) {
    const Planned p = planned(under_flat_land(surface, 400), flat());
    const Profile& before = p.profiles.roads[0].profile;
    EXPECT_NEAR(height_m(before, 400), kLand_m - needed_m(surface), 0.2);
    EXPECT_NEAR(height_m(before, 0), kLand_m, 0.05);
    EXPECT_NEAR(height_m(p.profiles.off_ground[0], 0), height_m(before, 400), 2 * kKnotError_m);
    for (std::size_t k = 1; k < before.size(); ++k)
      EXPECT_LE(std::abs(before[k].z_m - before[k - 1].z_m),
                grade_rule_of(surface).limit * (before[k].at_m - before[k - 1].at_m) + 2 * kKnotError_m);
  }
}

TEST(Mouths, WallsStandBesideTheCutting) {
  const map::Features f = under_flat_land(kStreet, 400);
  const Planned p = planned(f, flat());
  const GradedTerrain graded = graded_by(f, p.profiles, flat());
  ASSERT_EQ(p.profiles.roads[0].cuttings.size(), 1u);
  const roads::Cutting cutting = p.profiles.roads[0].cuttings[0];
  EXPECT_GT(cutting.from_m, 300);
  EXPECT_GE(cutting.to_m, 400);
  // 2.5 m above the road, 0.25 m beside its edge
  const double deep_m = height_m(p.profiles.roads[0].profile, 385);
  EXPECT_LT(deep_m, kLand_m - 2.5);
  EXPECT_NEAR(land_m(graded, {-65, 3.25}), kLand_m, 0.01);
  EXPECT_NEAR(layer_height_m(heights_at(graded, {-65, 0}), HeightLayer::kRoad), deep_m, 0.05);
}

TEST(Mouths, AWallOnTheRoadReachesDownToIt) {
  const map::Features f = under_flat_land(kStreet, 400);
  const Planned p = planned(f, flat());
  const std::vector<LandCoverPolygon> paved{
      {.id = {}, .surface = kStreet, .area_m2 = 1, .rings = {{{-450, -3}, {-50, -3}, {-50, 3}, {-450, 3}}}}};
  const GradedTerrain graded = grade_terrain(
      flat(), {.roads = p.profiles.roads, .streams = {}, .surfaces = paved, .box = {{-900, -900}, {900, 900}}});
  const double deep_m = height_m(p.profiles.roads[0].profile, 385);
  EXPECT_NEAR(wall_ground_m(graded, {-65, 3}), deep_m, 0.25) << "at the edge of the road";
  EXPECT_NEAR(wall_ground_m(graded, {-65, 3.5}), kLand_m, 0.05) << "beside it";
}

TEST(Mouths, JunctionsAndCrossedPlacesStay) {
  for (const LandCoverClass beside : {kStreet, LandCoverClass::kPavedFootPath}) {
    map::Features f = under_flat_land(kStreet, 400);
    f.tracks[0].axis = {{-450, 0}, {-90, 0}, {-50, 0}};
    f.tracks[0] = track(1, f.tracks[0].axis);
    f.tracks.push_back(track(4, {{-90, -200}, {-90, 0}, {-90, 200}}, beside));
    const Planned p = planned(f, flat());
    EXPECT_NEAR(height_m(p.profiles.roads[0].profile, 360), kLand_m, 0.1);
    EXPECT_LT(height_m(p.profiles.roads[0].profile, 400), kLand_m - 1);
    EXPECT_NEAR(height_m(p.profiles.roads[1].profile, 0), kLand_m - needed_m(kStreet), 0.2);
  }
}

TEST(Mouths, ALandThatCoversATunnelLowersNoMouth) {
  const map::Heightfield hill =
      field_from([](double x, double) { return kLand_m + std::max(0.0, 50 - std::abs(x)); }, 1024, 2);
  const Planned p = planned(under_flat_land(kStreet, 400), hill);
  EXPECT_NEAR(height_m(p.profiles.roads[0].profile, 400), kLand_m, 0.5);
  EXPECT_TRUE(p.profiles.roads[0].cuttings.empty());
}

TEST(Mouths, ACorridorOnTheGroundStays) {
  map::Features f = under_flat_land(LandCoverClass::kPavedFootPath, 400);
  f.tracks[1].layer = 0;
  EXPECT_FALSE(needs_cover(f.tracks[1]));
  EXPECT_NEAR(height_m(planned(f, flat()).profiles.off_ground[0], 50), kLand_m, 0.1);
}

}  // namespace
}  // namespace citykiln::ground
