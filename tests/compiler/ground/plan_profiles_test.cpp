#include "compiler/ground/plan_profiles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "compiler/ground/crossings.h"
#include "compiler/ground/grade_rules.h"
#include "compiler/ground/junction_planes.h"
#include "compiler/ground/line_heights.h"
#include "compiler/ground/profile_knots.h"
#include "tests/compiler/ground/made_network.h"

namespace citykiln::ground {
namespace {

using map::Passage;
using map::SurfaceClass;

constexpr auto kStreet = SurfaceClass::kResidentialRoad;

double length_m(const map::Track& track) { return citykiln::length_m(track.axis); }

double largest_difference_m(const Profile& a, const Profile& b, double length_m) {
  double largest = 0;
  for (double at = 0; at <= length_m; at += 0.5)
    largest = std::max(largest, std::abs(height_m(a, at) - height_m(b, at)));
  return largest;
}

TEST(Profiles, KeepTheGradeLimitsOfTheirClasses) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const Planned p = planned(street_grid(seed, 10), hilly_field(seed, 40, 6));
    EXPECT_EQ(p.measures.over_m, 0) << "seed " << seed;
    EXPECT_EQ(p.report.counts().count(Code::kTooSteep), 0u);
  }
}

TEST(Profiles, DiagnoseWhatStaysTooSteep) {
  map::Features f;
  f.tracks = {track(1, {{-900, 0}, {900, 0}})};
  const Planned p = planned(f, field_of([](double x, double) { return x * 0.6; }));
  EXPECT_EQ(p.report.counts().at(Code::kTooSteep), 1u);
  const auto found = std::ranges::find(p.report.diagnoses(), Code::kTooSteep, &Diagnosis::code);
  EXPECT_NEAR(found->size, 0.6, 0.1);
}

TEST(Profiles, AreEquallyHighWhereWaysShareANode) {
  for (std::uint64_t seed = 0; seed < 30; ++seed)
    EXPECT_LE(planned(street_grid(seed, 10), hilly_field(seed, 150, 10)).measures.largest_jump_m, kKnotError_m) << seed;
}

TEST(Profiles, LieOnTheGridsOfTheManifestAndRiseAlongTheWay) {
  const map::Features f = street_grid(5, 10);
  const Planned p = planned(f, hilly_field(5, 60, 6));
  for (const roads::Road& road : p.profiles.roads) {
    ASSERT_GE(road.profile.size(), 2u);
    EXPECT_EQ(road.profile.front().at_m, 0);
    EXPECT_NEAR(road.profile.back().at_m, roads::distances_along(road).back(), 0.125);
    EXPECT_LE(road.profile.back().at_m, roads::distances_along(road).back());
    for (std::size_t i = 0; i < road.profile.size(); ++i) {
      const Knot& k = road.profile[i];
      EXPECT_EQ(k.at_m * 8, std::floor(k.at_m * 8));
      EXPECT_EQ(k.z_m / kProfileQuantum_m, std::floor(k.z_m / kProfileQuantum_m));
      EXPECT_EQ(k.tilt / kTiltQuantum, std::floor(k.tilt / kTiltQuantum));
      EXPECT_TRUE(i == 0 || k.at_m > road.profile[i - 1].at_m);
    }
  }
}

// Points of the arms up to their cuts: on the axis, and to either side of it at the cut; in between the tilt comes from
// that at the place, which is that of the mean direction.
std::vector<Vec3> points_of(const roads::Junction& junction, std::span<const roads::Arm> arms,
                            std::span<const roads::Road> roads) {
  std::vector<Vec3> points;
  for (std::size_t a = 0; a < arms.size(); ++a) {
    const roads::Road& road = roads[arms[a].road];
    const double from_m = roads::distances_along(road)[arms[a].vertex];
    if (junction.cuts[a].length_m == roads::kWhole_m) continue;
    const Polyline path = roads::walk(roads, arms[a], junction.cuts[a].length_m);
    if (path.size() != 2) continue;
    const Vec2 along = unit(path[1] - path[0]), left = left_of(along) * arms[a].step;
    const auto add = [&](double run_m, double side_m) {
      const Knot knot = knot_at(road.profile, from_m + arms[a].step * run_m);
      points.push_back(at_height(path[0] + along * run_m + left * side_m, knot.z_m + side_m * knot.tilt));
    };
    const double cut_m = citykiln::length_m(path);
    for (double run_m = 0; run_m <= cut_m; run_m += 0.5) add(run_m, 0);
    add(cut_m, 3), add(cut_m, -3);
  }
  return points;
}

// The largest distance to the plane through three of them that are far apart.
double bulge_m(const std::vector<Vec3>& points) {
  const Vec3 a = points.front();
  Vec3 b = a, normal{};
  for (const Vec3 p : points)
    if (length(p - a) > length(b - a)) b = p;
  for (const Vec3 p : points)
    if (length(cross(b - a, p - a)) > length(normal)) normal = cross(b - a, p - a);
  double worst = 0;
  for (const Vec3 p : points) worst = std::max(worst, std::abs(dot(p - a, unit(normal))));
  return worst;
}

TEST(Profiles, JunctionsArePlanesNoSteeperThanAllowed) {
  int junctions = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Planned p = planned(street_grid(seed, 8), hilly_field(seed, 60, 6));
    const auto arms = roads::arms_of(p.junctions, p.profiles.roads);
    for (std::size_t j = 0; j < arms.size(); ++j) {
      const std::vector<Vec3> points = points_of(p.junctions[j], arms[j], p.profiles.roads);
      if (points.size() < 6) continue;
      ++junctions;
      EXPECT_LT(bulge_m(points), 0.03) << "seed " << seed << ", junction " << j;
      for (const roads::Arm& arm : arms[j]) {
        const double at_m = roads::distances_along(p.profiles.roads[arm.road])[arm.vertex];
        EXPECT_LE(std::abs(knot_at(p.profiles.roads[arm.road].profile, at_m).tilt), kPlaneSlope + kTiltQuantum);
      }
    }
  }
  EXPECT_GT(junctions, 300);
}

TEST(Profiles, OfFlatLandAtZeroAreEmpty) {
  const Planned p = planned(street_grid(1, 10), field_of([](double, double) { return 0; }));
  for (const roads::Road& road : p.profiles.roads) EXPECT_TRUE(road.profile.empty());
}

TEST(Profiles, OfFlatLandElsewhereAreTwoKnotsAndThoseOfMeetings) {
  const Planned p = planned(street_grid(1, 10), field_of([](double, double) { return 250; }));
  for (const roads::Road& road : p.profiles.roads) {
    EXPECT_LE(road.profile.size(), 10u);
    for (const Knot& k : road.profile) EXPECT_EQ(std::pair(k.z_m, k.tilt), std::pair(250.0, 0.0));
  }
}

TEST(Profiles, FootPathsHaveNone) {
  map::Features f;
  f.tracks = {track(1, {{-50, 0}, {50, 0}}, SurfaceClass::kFootPath),
              track(2, {{0, -50}, {0, 50}}, SurfaceClass::kSteps)};
  const Planned p = planned(f, hilly_field(1, 40, 4));
  for (const roads::Road& road : p.profiles.roads) EXPECT_TRUE(road.profile.empty());
}

TEST(Profiles, DoNotDependOnTheOrderOfTracks) {
  map::Features f = street_grid(3, 8);
  f.tracks.push_back(track(900, {{-300, -460}, {300, 460}}, kStreet, Passage::kBridge, 1));
  f.tracks.push_back(track(901, {{-460, 300}, {460, -300}}, kStreet, Passage::kTunnel, -1));
  const map::Heightfield heights = hilly_field(3, 60, 6);
  const Planned one = planned(f, heights);
  std::ranges::reverse(f.tracks);
  const Planned two = planned(f, heights);
  EXPECT_EQ(one.profiles.roads, two.profiles.roads);
  EXPECT_EQ(one.profiles.off_ground[0], two.profiles.off_ground[1]);
  EXPECT_EQ(one.profiles.off_ground[1], two.profiles.off_ground[0]);
}

// Streets along 8 km; what is far is changed: heights, ways, tags.
TEST(Profiles, DoNotDependOnWhatLiesBeyondTheirReach) {
  constexpr double kFrom_m = kProfileReach_m;
  const auto ladder = [](bool is_other) {
    map::Features f;
    std::int64_t id = 0;
    for (int i = -64; i < 64; ++i) {
      const double x = 128.0 * i;
      const bool is_far = x > 600 + kFrom_m && is_other;
      f.tracks.push_back(
          track(++id, {{x, 0}, {x + 61, 7}, {x + 128, 0}}, is_far ? SurfaceClass::kPrimaryRoad : kStreet));
      f.tracks.push_back(track(++id, {{x, 0}, {x + 9, 70}, {x, 150}}, SurfaceClass::kServiceRoad));
      if (!is_far)
        f.tracks.push_back(track(++id, {{x, 150}, {x + 128, 150}}, kStreet));
      else
        ++id;
    }
    return f;
  };
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    map::Heightfield heights = hilly_field(seed, 120, 8, 8192);
    const Planned one = planned(ladder(false), heights);
    for (int j = 0; j < heights.rows; ++j)
      for (int i = 0; i < heights.columns; ++i)
        if (heights.vertex(i, j).x > 600 + kFrom_m)
          heights.heights[static_cast<std::size_t>(j * heights.columns + i)] += 64 * ((i * 7 + j * 13) % 50);
    const Planned two = planned(ladder(true), heights);
    int same = 0, differ = 0;
    for (const roads::Road& a : one.profiles.roads) {
      const auto b = std::ranges::find(two.profiles.roads, a.id, &roads::Road::id);
      const bool is_near = a.axis.back().x < 600;
      EXPECT_TRUE(!is_near || a.profile == b->profile) << a.id.osm.id;
      ++(b != two.profiles.roads.end() && a.profile == b->profile ? same : differ);
    }
    EXPECT_GT(same, 150);
    EXPECT_GT(differ, 20);
  }
}

TEST(Profiles, ASpikeOfTheHeightmapMovesThemByEightMetresAtMost) {
  const Draw draw(1, StableId{9}, "spikes");
  double largest = 0;
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    const map::Features f = street_grid(seed, 10);
    map::Heightfield heights = hilly_field(seed, 40, 4);
    const Planned calm = planned(f, heights);
    const int i = 26 + static_cast<int>(draw.unit(4 * seed) * 12),
              j = 26 + static_cast<int>(draw.unit(4 * seed + 1) * 12);
    const double spike_m = (seed % 2 ? 1 : -1) * (seed % 4 < 2 ? 500 : draw.between(20, 200, 4 * seed + 2));
    heights.heights[static_cast<std::size_t>(j * heights.columns + i)] +=
        static_cast<int>(spike_m / map::kHeightQuantum_m);
    const Planned spiked = planned(f, heights);
    for (std::size_t r = 0; r < f.tracks.size(); ++r)
      largest = std::max(largest, largest_difference_m(calm.profiles.roads[r].profile, spiked.profiles.roads[r].profile,
                                                       length_m(f.tracks[r])));
  }
  std::printf("a spike moves a profile by %.2f m at most\n", largest);
  EXPECT_LT(largest, 8);
}

TEST(Profiles, FollowTheGroundWithoutItsNoise) {
  map::Features f;
  f.tracks = {track(1, {{-900, 3}, {900, 11}}, SurfaceClass::kSecondaryRoad)};
  const auto slope = [](double x) { return 300 + x * 0.04; };
  const Draw draw(4, StableId{3}, "noise");
  std::uint32_t next = 0;
  const auto noisy = field_of([&](double x, double) { return slope(x) + draw.between(-6, 6, next++); });
  const Profile profile = planned(f, noisy).profiles.roads[0].profile;
  double squares = 0, rough = 0;
  for (double at = 0; at < 1800; at += 4) {
    const double off_m = height_m(profile, at) - slope(at - 900),
                 raw_m = height_m_at(noisy, {at - 900, 5}) - slope(at - 900);
    squares += off_m * off_m, rough += raw_m * raw_m;
  }
  EXPECT_LT(squares, 0.6 * rough);
  for (std::size_t k = 1; k < profile.size(); ++k) {
    const double grade = (profile[k].z_m - profile[k - 1].z_m) / (profile[k].at_m - profile[k - 1].at_m);
    EXPECT_NEAR(grade, 0.04, 0.05);
  }
}

// A road, a bridge of it over x from -30 to 30, and another below along y.
map::Features crossing(Passage passage, int layer, SurfaceClass upper = kStreet, SurfaceClass lower = kStreet) {
  map::Features f;
  f.tracks = {track(1, {{-800, 0}, {-30, 0}}, upper), track(2, {{-30, 0}, {30, 0}}, upper, passage, layer),
              track(3, {{30, 0}, {800, 0}}, upper), track(4, {{0, -800}, {0, 800}}, lower)};
  return f;
}

double gap_m(const Planned& p) {
  return height_m(p.profiles.off_ground[0], 30) - height_m(p.profiles.roads.back().profile, 800);
}

TEST(Profiles, ABridgeClearsWhatItCrossesAndItsApproachesKeepTheirLimit) {
  for (const int layer : {0, 1, 5}) {
    for (const auto upper : {kStreet, SurfaceClass::kMotorwayRoad, SurfaceClass::kRailway}) {
      for (const double slope : {0.0, 0.01}) {
        const Planned p = planned(crossing(Passage::kBridge, layer, upper),
                                  field_of([&](double x, double) { return 40 + x * slope; }));
        EXPECT_GE(gap_m(p), kOverRoad_m - 0.1);
        EXPECT_LE(gap_m(p), kOverRoad_m + 0.6);
        EXPECT_EQ(p.measures.over_m, 0);
        EXPECT_NEAR(height_m(p.profiles.roads[0].profile, 0), 40 - 800 * slope, 0.5);
        EXPECT_EQ(p.report.counts().count(Code::kClearanceNotMet), 0u);
      }
    }
  }
  const Planned p = planned(crossing(Passage::kBridge, 1, kStreet, SurfaceClass::kRailway),
                            field_of([](double, double) { return 40; }));
  EXPECT_GE(gap_m(p), kOverRail_m - 0.1);
}

TEST(Profiles, ARampEndsOnASlopeToo) {
  const Planned p = planned(crossing(Passage::kBridge, 1), field_of([](double x, double) { return 300 + 0.12 * x; }));
  EXPECT_GE(gap_m(p), kOverRoad_m - 0.3);
  for (const double at : {400.0, 600.0}) {
    EXPECT_NEAR(height_m(p.profiles.roads[0].profile, 770 - at), 300 - 0.12 * (at + 30), 0.3);
    EXPECT_NEAR(height_m(p.profiles.roads[1].profile, at), 300 + 0.12 * (at + 30), 0.3);
  }
}

TEST(Profiles, OnlyWhatIsLiftedAgainMayBeSteeper) {
  // a bridge on a slope so steep that its limit takes back some of the lift, far from hilly streets
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    map::Features f = street_grid(seed, 8, {-1400, -480});
    const std::size_t streets = f.tracks.size();
    for (map::Track t : crossing(Passage::kBridge, 1).tracks) {
      for (Vec2& p : t.axis) p.x += 1000;
      t.id.osm.id += 100;
      f.tracks.push_back(std::move(t));
    }
    const map::Heightfield hills = hilly_field(seed, 40, 6);
    const Planned p = planned(f, field_of([&](double x, double y) {
                                return x < 0 ? height_m_at(hills, {x, y}) : 120 + 0.17 * std::max(0.0, x - 100);
                              }));
    EXPECT_GE(height_m(p.profiles.off_ground[0], 30) - height_m(p.profiles.roads.back().profile, 800),
              kOverRoad_m - kLackMargin_m);
    for (std::size_t i = 0; i < streets; ++i) {
      const Profile& profile = p.profiles.roads[i].profile;
      const double limit = grade_rule_of(p.profiles.roads[i].surface).limit;
      for (std::size_t k = 1; k < profile.size(); ++k)
        EXPECT_LE(std::abs(profile[k].z_m - profile[k - 1].z_m),
                  limit * (profile[k].at_m - profile[k - 1].at_m) + 2 * kKnotError_m)
            << seed;
    }
  }
}

TEST(Profiles, ATunnelGoesBelowWhatItCrossesWithItsApproaches) {
  const Planned p = planned(crossing(Passage::kTunnel, 0), field_of([](double, double) { return 40; }));
  EXPECT_LE(gap_m(p), -kOverRoad_m + 0.1);
  EXPECT_NEAR(height_m(p.profiles.roads.back().profile, 800), 40, 0.01);
  EXPECT_EQ(p.measures.over_m, 0);
}

TEST(Profiles, ATunnelThatGoesDownIsDiagnosed) {
  const Planned flat = planned(crossing(Passage::kTunnel, 0), field_of([](double, double) { return 40; }));
  const auto found = std::ranges::find(flat.report.diagnoses(), Code::kTunnelDug, &Diagnosis::code);
  ASSERT_NE(found, flat.report.diagnoses().end());
  EXPECT_EQ(found->object, (OsmId{OsmType::kWay, 2}));
  EXPECT_NEAR(found->size, kOverRoad_m, 0.5);
  const Planned bridge = planned(crossing(Passage::kBridge, 1), field_of([](double, double) { return 40; }));
  EXPECT_EQ(bridge.report.counts().count(Code::kTunnelDug), 0u);
}

TEST(Profiles, ALongTunnelGoesDownBetweenItsMouthsAlone) {
  map::Features f = crossing(Passage::kTunnel, -1);
  f.tracks[0] = track(1, {{-800, 0}, {-300, 0}});
  f.tracks[1] = track(2, {{-300, 0}, {300, 0}}, kStreet, Passage::kTunnel, -1);
  f.tracks[2] = track(3, {{300, 0}, {800, 0}});
  const Planned p = planned(f, field_of([](double, double) { return 40; }));
  EXPECT_NEAR(height_m(p.profiles.off_ground[0], 300), 33, 0.5);
  EXPECT_NEAR(height_m(p.profiles.roads[0].profile, 490), 40, 0.1);
}

TEST(Profiles, ABridgeThatCrossesNothingIsNoHump) {
  for (const int layer : {-2, 0, 1, 5}) {
    map::Features f = crossing(Passage::kBridge, layer);
    f.tracks.pop_back();
    const Planned p = planned(f, field_of([](double, double) { return 40; }));
    for (const Knot& k : p.profiles.off_ground[0]) EXPECT_EQ(k.z_m, 40);
  }
}

TEST(Profiles, AShortTunnelInFlatLandIsNoPit) {
  map::Features f = crossing(Passage::kTunnel, -1);
  f.tracks.pop_back();
  const Planned p = planned(f, field_of([](double, double) { return 40; }));
  EXPECT_GT(height_m(p.profiles.off_ground[0], 30), 40 - kCover_m);
  for (const roads::Road& road : p.profiles.roads)
    for (const Knot& k : road.profile) EXPECT_EQ(k.z_m, 40);
}

TEST(Profiles, ALayerWithoutABridgeIsGround) {
  const Planned p = planned(crossing(Passage::kGround, 3), field_of([](double, double) { return 40; }));
  for (const roads::Road& road : p.profiles.roads)
    for (const Knot& k : road.profile) EXPECT_EQ(k.z_m, 40);
}

TEST(Profiles, ABridgeRunsStraightOverAValley) {
  map::Features f = crossing(Passage::kBridge, 1);
  f.tracks[0] = track(1, {{-800, 0}, {-200, 0}});
  f.tracks[1] = track(2, {{-200, 0}, {200, 0}}, kStreet, Passage::kBridge, 1);
  f.tracks[2] = track(3, {{200, 0}, {800, 0}});
  const Planned p = planned(f, field_of([](double x, double) { return std::abs(x) >= 192 ? 100 + x / 40 : 40; }));
  for (double at = 0; at <= 400; at += 8)
    EXPECT_NEAR(height_m(p.profiles.off_ground[0], at), 100 + (at - 200) / 40, 2.0) << at;
}

TEST(Profiles, AStackClearsStoreyByStorey) {
  map::Features f;
  f.tracks = {track(1, {{-800, 0}, {800, 0}})};
  const Vec2 directions[] = {{0, 1}, {0.6, 0.8}, {-0.6, 0.8}};
  for (int k = 0; k < 3; ++k) {
    const auto at = [&](double run_m) {
      return Vec2{std::floor(directions[k].x * run_m * 128) / 128, std::floor(directions[k].y * run_m * 128) / 128};
    };
    f.tracks.push_back(track(10 * k + 10, {at(-800), at(-150)}));
    f.tracks.push_back(track(10 * k + 11, {at(-150), at(150)}, kStreet, Passage::kBridge, k + 1));
    f.tracks.push_back(track(10 * k + 12, {at(150), at(800)}));
  }
  const Planned p = planned(f, field_of([](double, double) { return 40; }));
  for (int k = 0; k < 3; ++k)
    EXPECT_GE(height_m(p.profiles.off_ground[static_cast<std::size_t>(k)], 150), 40 + kOverRoad_m * (k + 1) - 0.2);
  EXPECT_LT(p.measures.largest_lack_m, kLackMargin_m);
  EXPECT_EQ(p.measures.over_m, 0);
}

constexpr auto kFootway = SurfaceClass::kPavedFootPath;

TEST(Profiles, DiagnoseAClearanceThatIsNotMet) {
  // it comes down on paths too long to climb with it
  map::Features f = crossing(Passage::kBridge, 1, SurfaceClass::kMotorwayRoad);
  f.tracks[0] = track(1, {{-1400, 0}, {-30, 0}}, kFootway);
  f.tracks[2] = track(3, {{30, 0}, {1400, 0}}, kFootway);
  const Planned p = planned(f, field_of([](double, double) { return 40; }));
  EXPECT_EQ(p.report.counts().at(Code::kClearanceNotMet), 1u);
  EXPECT_EQ(p.measures.lacking, 1u);
  EXPECT_NEAR(p.measures.largest_lack_m, kOverRoad_m - 0.06 * 30, 0.5);
}

TEST(Profiles, ABridgesEndThatMeetsNothingMayRise) {
  map::Features f = crossing(Passage::kBridge, 1, SurfaceClass::kMotorwayRoad);
  f.tracks.erase(f.tracks.begin());
  const Planned p = planned(f, field_of([](double, double) { return 40; }));
  EXPECT_EQ(p.report.counts().at(Code::kBridgeWithoutGround), 1u);
  EXPECT_EQ(p.report.counts().count(Code::kClearanceNotMet), 0u);
  EXPECT_GT(p.profiles.off_ground[0].front().z_m, 43);
}

// A footway along x, `passage` from -10 to 10, steps of 16 m and long paths beyond; a street along y.
map::Features footbridge(Passage passage, int layer) {
  map::Features f;
  f.tracks = {track(1, {{-1500, 0}, {-26, 0}}, kFootway),
              track(2, {{-26, 0}, {-10, 0}}, SurfaceClass::kSteps),
              track(3, {{-10, 0}, {10, 0}}, kFootway, passage, layer),
              track(4, {{10, 0}, {26, 0}}, SurfaceClass::kSteps),
              track(5, {{26, 0}, {1500, 0}}, kFootway),
              track(6, {{0, -300}, {0, 300}})};
  return f;
}

TEST(Profiles, StepsClimbToTheirFootbridgeAndGoDownToTheirUnderpass) {
  for (const auto& [passage, layer] : {std::pair(Passage::kBridge, 1), std::pair(Passage::kTunnel, -1)}) {
    const Planned p = planned(footbridge(passage, layer), field_of([](double, double) { return 40; }));
    EXPECT_EQ(p.measures.crossings, 1u);
    EXPECT_LE(p.measures.largest_lack_m, kLackMargin_m);
    const double rise_m = height_m(p.profiles.off_ground[0], 0) - 40;
    EXPECT_GT(rise_m * layer, 1.5);
    // the street stays, the steps join the deck and the ground
    for (const Knot& k : p.profiles.roads[4].profile) EXPECT_EQ(k.z_m, 40);
    EXPECT_NEAR(height_m(p.profiles.roads[1].profile, 16), 40 + rise_m, kKnotError_m);
    EXPECT_NEAR(height_m(p.profiles.roads[1].profile, 0), 40, 0.5);
    EXPECT_TRUE(p.profiles.roads[0].profile.empty());
  }
}

TEST(Profiles, AFootbridgeGoesStraightFromCrestToCrest) {
  map::Features f;
  f.tracks = {track(1, {{-90, 0}, {-60, 0}}, SurfaceClass::kSteps),
              track(2, {{-60, 0}, {60, 0}}, kFootway, Passage::kBridge, 1),
              track(3, {{60, 0}, {90, 0}}, SurfaceClass::kSteps), track(4, {{-40, -300}, {-40, 300}}),
              track(5, {{40, -300}, {40, 300}})};
  const Planned p = planned(f, field_of([](double, double) { return 40; }));
  EXPECT_EQ(p.measures.lacking, 0u);
  for (double at = 20; at <= 100; at += 4) EXPECT_GT(height_m(p.profiles.off_ground[0], at), 44.7) << at;
}

TEST(Profiles, PathsThatNeedNotClimbKeepNone) {
  map::Features f = footbridge(Passage::kBridge, 1);
  f.tracks.pop_back();
  const Planned p = planned(f, hilly_field(3, 40, 4));
  for (const roads::Road& road : p.profiles.roads) EXPECT_TRUE(road.profile.empty());
}

TEST(Profiles, APathGoesDownUnderABridgeThatCannotRise) {
  map::Features f = crossing(Passage::kBridge, 1, SurfaceClass::kMotorwayRoad);
  f.tracks[0] = track(1, {{-1400, 0}, {-30, 0}}, kFootway);
  f.tracks[2] = track(3, {{30, 0}, {1400, 0}}, kFootway);
  f.tracks[3] = track(4, {{0, -100}, {0, 100}}, kFootway);
  const Planned p = planned(f, field_of([](double, double) { return 40; }));
  EXPECT_EQ(p.measures.lacking, 0u);
  EXPECT_LT(height_m(p.profiles.roads[2].profile, 100), 39);
  EXPECT_NEAR(height_m(p.profiles.roads[2].profile, 0), 40, kKnotError_m);
}

TEST(Profiles, ATunnelGoesDownUnderABridgeThatCannotRise) {
  map::Features f = crossing(Passage::kBridge, 1, SurfaceClass::kMotorwayRoad);
  f.tracks[0] = track(1, {{-1400, 0}, {-30, 0}}, kFootway);
  f.tracks[2] = track(3, {{30, 0}, {1400, 0}}, kFootway);
  f.tracks[3] = track(4, {{0, -800}, {0, -30}});
  f.tracks.push_back(track(5, {{0, -30}, {0, 30}}, kStreet, Passage::kTunnel, -1));
  f.tracks.push_back(track(6, {{0, 30}, {0, 800}}));
  const Planned p = planned(f, field_of([](double, double) { return 40; }));
  EXPECT_EQ(p.measures.lacking, 0u);
}

TEST(Profiles, WhatComesDownBesideALineDoesNotPassOverIt) {
  // a bridge ends on its own street, a lane's width beside another
  map::Features f;
  f.tracks = {track(1, {{-300, 4}, {-30, 4}}), track(2, {{-30, 4}, {30, 4}}, kStreet, Passage::kBridge, 1),
              track(3, {{30, 4}, {300, 4}}), track(4, {{20, 0}, {300, 0}})};
  EXPECT_EQ(planned(f, field_of([](double, double) { return 40; })).measures.crossings, 0u);
  // all along, it does
  f.tracks[3] = track(4, {{-300, 0}, {300, 0}});
  f.tracks[1] = track(2, {{-30, 4}, {-10, 40}, {10, 40}, {30, 4}}, kStreet, Passage::kBridge, 1);
  f.tracks.push_back(track(5, {{-300, 38}, {300, 38}}));
  EXPECT_GE(planned(f, field_of([](double, double) { return 40; })).measures.crossings, 1u);
}

TEST(Profiles, AFootbridgeComesDownOnItsPaths) {
  map::Features f;
  f.tracks = {track(1, {{-100, 0}, {-40, 0}}, SurfaceClass::kPavedFootPath),
              track(2, {{-40, 0}, {40, 0}}, SurfaceClass::kPavedFootPath, Passage::kBridge, 1),
              track(3, {{40, 0}, {100, 0}}, SurfaceClass::kPavedFootPath), track(4, {{0, -300}, {0, 300}})};
  const map::Heightfield heights = field_of([](double x, double) { return 40 + x / 50; });
  const Planned p = planned(f, heights);
  EXPECT_NEAR(p.profiles.off_ground[0].front().z_m, height_m_at(heights, {-40, 0}), kProfileQuantum_m);
  EXPECT_NEAR(p.profiles.off_ground[0].back().z_m, height_m_at(heights, {40, 0}), kProfileQuantum_m);
  EXPECT_GE(height_m(p.profiles.off_ground[0], 40) - height_m(p.profiles.roads[2].profile, 300),
            kOverRoad_m - kThinDeck_m - 0.1);
}

TEST(Profiles, BridgesClearStandingWater) {
  map::Features f = crossing(Passage::kBridge, 1);
  f.tracks.pop_back();
  Surface lake{{{OsmType::kWay, 99}, 0}, SurfaceClass::kLake, 800, {{{-20, -20}, {20, -20}, {20, 20}, {-20, 20}}}};
  lake.level_m = 39.5;
  Report report;
  const auto roads = roads::plan(f, report);
  const map::Heightfield heights = field_of([](double, double) { return 40; });
  const Profiles p = plan_profiles(f, roads, {}, {}, std::span(&lake, 1), heights, report);
  EXPECT_GE(height_m(p.off_ground[0], 30), 39.5 + kOverWater_m - 0.05);
}

}  // namespace
}  // namespace citykiln::ground
