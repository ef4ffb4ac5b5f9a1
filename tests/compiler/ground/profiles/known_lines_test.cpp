#include "compiler/ground/profiles/known_lines.h"

#include <gtest/gtest.h>

#include "compiler/ground/profiles/plan_profiles.h"
#include "tests/compiler/ground/profiles/made_network.h"

namespace citykiln::ground {
namespace {

std::vector<KnownLine> known_of(const map::Features& features, const map::Heightfield& heights) {
  Report report;
  const std::vector<roads::Road> roads = roads::roads_on_ground(features, report);
  const std::vector<roads::Junction> junctions = roads::plan_junctions(roads, report);
  return plan_line_profiles(features, roads, junctions, {}, {}, heights, report).known;
}

double known_length_m(const std::vector<KnownLine>& lines) {
  double sum_m = 0;
  for (const KnownLine& line : lines) sum_m += distance(line.from, line.to);
  return sum_m;
}

const map::Heightfield kHills = hilly_field(1, 40, 4);

TEST(KnownLines, AreRoadsOnTheLand) {
  map::Features features;
  features.tracks = {track(1, {{-400, 0}, {400, 0}})};
  const std::vector<KnownLine> lines = known_of(features, kHills);
  EXPECT_NEAR(known_length_m(lines), 800, 1);
  for (const KnownLine& line : lines) EXPECT_EQ(line.kind, KnownKind::kRoad);
}

TEST(KnownLines, LeaveOutCuttingsAndEmbankmentsThatAreMapped) {
  map::Features features;
  features.tracks = {track(1, {{-400, 0}, {400, 0}})};
  features.tracks[0].is_in_earthwork = true;
  EXPECT_TRUE(known_of(features, kHills).empty());
}

TEST(KnownLines, LeaveOutBridgesAndTheCuttingsBeforeTunnels) {
  map::Features features;
  features.tracks = {track(1, {{-400, 0}, {0, 0}}), track(2, {{0, 0}, {200, 0}}, kStreet, map::Passage::kTunnel, -1)};
  EXPECT_LT(known_length_m(known_of(features, kHills)), 400 - kPortalCutting_m + 1);
  features.tracks[1].passage = map::Passage::kBridge;
  EXPECT_NEAR(known_length_m(known_of(features, kHills)), 400, 1);
}

TEST(KnownLines, HaveTheHeightOfTheLandBelowRampsToCrossings) {
  map::Features features;
  features.tracks = {track(1, {{-400, 0}, {-30, 0}}), track(2, {{-30, 0}, {30, 0}}, kStreet, map::Passage::kBridge, 1),
                     track(3, {{30, 0}, {400, 0}}), track(4, {{0, -400}, {0, 400}})};
  const std::vector<KnownLine> lines = known_of(features, field_from([](double, double) { return 100; }));
  for (const KnownLine& line : lines) EXPECT_NEAR(line.from_m, 100, kLeastRamp_m);
  EXPECT_NEAR(known_length_m(lines), 740 + 800, 2);
}

}  // namespace
}  // namespace citykiln::ground
