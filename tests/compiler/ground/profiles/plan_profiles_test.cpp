#include "compiler/ground/profiles/plan_profiles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "compiler/ground/profiles/graph/grade_rules.h"
#include "compiler/ground/profiles/smoothing/initial_heights.h"
#include "compiler/ground/profiles/smoothing/junction_planes.h"
#include "compiler/ground/profiles/smoothing/profile_knots.h"
#include "tests/compiler/ground/profiles/made_network.h"

namespace citykiln::ground {
namespace {

using map::LandCoverClass;
using map::Passage;

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
    EXPECT_GT(p.measures.length_m, 0);
    EXPECT_EQ(p.measures.over_m, 0) << "seed " << seed;
    EXPECT_EQ(p.report.counts().count(Code::kTooSteep), 0u);
  }
}

TEST(Profiles, ReportWhatStaysTooSteep) {
  map::Features f;
  f.tracks = {track(1, {{-900, 0}, {900, 0}})};
  const Planned p = planned(f, field_from([](double x, double) { return x * 0.6; }));
  EXPECT_EQ(p.report.counts().at(Code::kTooSteep), 1u);
  const auto found = std::ranges::find(p.report.diagnoses(), Code::kTooSteep, &Diagnosis::code);
  EXPECT_NEAR(found->size, 0.6, 0.1);
}

TEST(Profiles, AreEquallyHighWhereWaysShareANode) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const ProfileMeasures measures = planned(street_grid(seed, 10), hilly_field(seed, 150, 10)).measures;
    EXPECT_GT(measures.knots, 0u);
    EXPECT_LE(measures.largest_jump_m, kKnotError_m) << seed;
  }
}

// Knots lie on multiples of 1/8 m: one serves both the junction and the end.
TEST(Profiles, AreEquallyHighWhereAWayEndsJustBeyondANode) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const map::Heightfield heights = hilly_field(seed, 150, 10);
    for (const double end : {7, 8, 12}) {
      map::Features f;
      f.tracks = {track(1, {{-200, 50}, {0, 0}, {200, -70}}),
                  track(2, {{3, 22.109375}, {0, 0}, {0, -end / 128}}, LandCoverClass::kServiceRoad),
                  track(3, {{end / 128, 0}, {0, 0}, {-20, -90}}, LandCoverClass::kServiceRoad)};
      const ProfileMeasures measures = planned(f, heights).measures;
      EXPECT_GT(measures.knots, 0u);
      EXPECT_LE(measures.largest_jump_m, kKnotError_m) << seed;
    }
  }
}

TEST(Profiles, LieOnTheGridsOfTheManifestAndRiseAlongTheWay) {
  const map::Features f = street_grid(5, 10);
  const Planned p = planned(f, hilly_field(5, 60, 6));
  ASSERT_FALSE(p.profiles.roads.empty());
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

// Points of the arms up to their cuts: on the axis, and at the cut to either side of it. Between them the tilt at the
// place, in the mean direction, is interpolated.
std::vector<Vec3> points_of(const roads::Junction& junction, std::span<const roads::Arm> arms,
                            std::span<const roads::Road> roads) {
  std::vector<Vec3> points;
  for (std::size_t a = 0; a < arms.size(); ++a) {
    const roads::Road& road = roads[arms[a].road];
    const double from_m = roads::distances_along(road)[arms[a].vertex];
    if (junction.cuts[a].length_m == roads::kWholeLink_m) continue;
    const Polyline path = roads::arm_axis(roads, arms[a], junction.cuts[a].length_m);
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

// Returns the largest distance to the plane through three points that are far apart.
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
  const Planned p = planned(street_grid(1, 10), field_from([](double, double) { return 0; }));
  ASSERT_FALSE(p.profiles.roads.empty());
  for (const roads::Road& road : p.profiles.roads) EXPECT_TRUE(road.profile.empty());
}

TEST(Profiles, OfFlatLandElsewhereAreTwoKnotsAndThoseOfMeetings) {
  const Planned p = planned(street_grid(1, 10), field_from([](double, double) { return 250; }));
  ASSERT_FALSE(p.profiles.roads.empty());
  for (const roads::Road& road : p.profiles.roads) {
    EXPECT_GE(road.profile.size(), 1u);
    EXPECT_LE(road.profile.size(), 10u);
    for (const Knot& k : road.profile) EXPECT_EQ(std::pair(k.z_m, k.tilt), std::pair(250.0, 0.0));
  }
}

TEST(Profiles, FootPathsHaveNone) {
  map::Features f;
  f.tracks = {track(1, {{-50, 0}, {50, 0}}, LandCoverClass::kFootPath),
              track(2, {{0, -50}, {0, 50}}, LandCoverClass::kSteps)};
  const Planned p = planned(f, hilly_field(1, 40, 4));
  ASSERT_FALSE(p.profiles.roads.empty());
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

// Streets along 8 km; heights, ways and tags far away are changed.
TEST(Profiles, DoNotDependOnWhatLiesBeyondTheirReach) {
  constexpr double kFrom_m = kProfileRadius_m;
  const auto ladder = [](bool is_other) {
    map::Features f;
    std::int64_t id = 0;
    for (int i = -64; i < 64; ++i) {
      const double x = 128.0 * i;
      const bool is_far = x > 600 + kFrom_m && is_other;
      f.tracks.push_back(
          track(++id, {{x, 0}, {x + 61, 7}, {x + 128, 0}}, is_far ? LandCoverClass::kPrimaryRoad : kStreet));
      f.tracks.push_back(track(++id, {{x, 0}, {x + 9, 70}, {x, 150}}, LandCoverClass::kServiceRoad));
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

TEST(Profiles, ASummitAtOneVertexMovesThemByEightMetresAtMost) {
  const RandomSequence draw(1, StableId{9}, "spikes");
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
  f.tracks = {track(1, {{-900, 3}, {900, 11}}, LandCoverClass::kSecondaryRoad)};
  const auto slope = [](double x) { return 300 + x * 0.04; };
  const RandomSequence draw(4, StableId{3}, "noise");
  std::uint32_t next = 0;
  const auto noisy = field_from([&](double x, double) { return slope(x) + draw.between(-6, 6, next++); });
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

}  // namespace
}  // namespace citykiln::ground
