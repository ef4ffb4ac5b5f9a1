#include "compiler/structures/plan.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace citykiln::structures {
namespace {

using map::Passage;

map::Track residential_track(std::int64_t id, Passage passage, Polyline axis) {
  map::Track t;
  t.id = {{OsmType::kWay, id}, 0};
  t.axis = std::move(axis);
  t.surface = map::LandCoverClass::kResidentialRoad;
  t.section = {{{map::LaneKind::kDriving, map::LaneDirection::kBoth, 6}}, 3};
  t.passage = passage;
  return t;
}

map::Heightfield level_square_of_1_km(std::int32_t z_m) {
  map::Heightfield field{{-512, -512}, {512, 512}, 3, 3, {}, 0};
  field.heights.assign(9, static_cast<std::int32_t>(z_m / map::kHeightQuantum_m));
  return field;
}

TEST(Plan, GivesSpansTheirTracksProfiles) {
  map::Features f;
  f.tracks = {residential_track(1, Passage::kGround, {{-50, 0}, {0, 0}}),
              residential_track(2, Passage::kBridge, {{0, 0}, {30, 0}, {30, 40}}),
              residential_track(3, Passage::kTunnel, {{30, 40}, {60, 40}})};
  const std::vector<Profile> off_ground = {{{0, 10, 0}, {50, 12, 0}, {70, 11, 0}}, {{0, 11, 0}, {30, 8, 0}}};
  Report report;
  const Structures s = plan(f, off_ground, level_square_of_1_km(0), report);
  ASSERT_EQ(s.bridges.size(), 1u);
  EXPECT_EQ(s.bridges[0].axis, f.tracks[1].axis);
  EXPECT_EQ(s.bridges[0].profile, off_ground[0]);
  EXPECT_EQ(s.bridges[0].section, f.tracks[1].section);
  ASSERT_EQ(s.tunnels.size(), 1u);
  EXPECT_EQ(s.tunnels[0].profile, off_ground[1]);
  EXPECT_TRUE(report.balances());
}

TEST(Plan, DiagnosesTunnelsAboveTheTerrain) {
  map::Features f;
  f.tracks = {residential_track(3, Passage::kTunnel, {{0, 0}, {60, 0}})};
  const std::vector<Profile> off_ground = {{{0, 10, 0}}};
  Report flat, high;
  EXPECT_FALSE(plan(f, off_ground, level_square_of_1_km(12), flat).tunnels[0].is_bored);
  EXPECT_EQ(flat.counts()[Code::kTunnelNotMeshed], 1u);
  EXPECT_TRUE(plan(f, off_ground, level_square_of_1_km(40), high).tunnels[0].is_bored);
  EXPECT_EQ(high.counts()[Code::kTunnelNotMeshed], 0u);
}

TEST(Plan, SortsById) {
  map::Features f;
  for (const std::int64_t id : {5, 3, 9, 1})
    f.tracks.push_back(residential_track(id, Passage::kBridge, {{0, 0}, {30, 0}}));
  Report report;
  const Structures s = plan(f, std::vector<Profile>(4), level_square_of_1_km(0), report);
  EXPECT_TRUE(std::ranges::is_sorted(s.bridges, {}, &Span::id));
  EXPECT_EQ(s.bridges.size(), 4u);
}

}  // namespace
}  // namespace citykiln::structures
