#include "compiler/structures/plan.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace citykiln::structures {
namespace {

using map::Passage;

map::Track track(std::int64_t id, Passage passage, Polyline axis) {
  map::Track t;
  t.id = {{OsmType::kWay, id}, 0};
  t.axis = std::move(axis);
  t.surface = map::SurfaceClass::kResidentialRoad;
  t.section = {{{map::LaneKind::kDriving, map::LaneWay::kBoth, 6}}, 3};
  t.passage = passage;
  return t;
}

TEST(Plan, SpansLieOnTheirProfiles) {
  map::Features f;
  f.tracks = {track(1, Passage::kGround, {{-50, 0}, {0, 0}}), track(2, Passage::kBridge, {{0, 0}, {30, 0}, {30, 40}}),
              track(3, Passage::kTunnel, {{30, 40}, {60, 40}})};
  const std::vector<Profile> off_ground = {{{0, 10, 0}, {50, 12, 0}, {70, 11, 0}}, {{0, 11, 0}, {30, 8, 0}}};
  Report report;
  const Structures s = plan(f, off_ground, report);
  ASSERT_EQ(s.bridges.size(), 1u);
  EXPECT_EQ(s.bridges[0].axis, (std::vector<Vec3>{{0, 0, 10}, {30, 0, 11.2001953125}, {30, 20, 12}, {30, 40, 11}}));
  EXPECT_EQ(s.bridges[0].width_m, 6);
  ASSERT_EQ(s.tunnels.size(), 1u);
  EXPECT_EQ(s.tunnels[0].axis, (std::vector<Vec3>{{30, 40, 11}, {60, 40, 8}}));
  EXPECT_EQ(report.counts()[Code::kTunnelNotMeshed], 1u);
  EXPECT_TRUE(report.balances());
}

TEST(Plan, AKnotAtABendIsThatBend) {
  map::Features f;
  f.tracks = {track(2, Passage::kBridge, {{0, 0}, {30, 0}, {30, 40}})};
  const std::vector<Profile> off_ground = {{{0, 10, 0}, {30, 12, 0}, {70, 11, 0}}};
  Report report;
  EXPECT_EQ(plan(f, off_ground, report).bridges[0].axis, (std::vector<Vec3>{{0, 0, 10}, {30, 0, 12}, {30, 40, 11}}));
}

TEST(Plan, WithoutAProfileASpanLiesAtZero) {
  map::Features f;
  f.tracks = {track(2, Passage::kBridge, {{0, 0}, {30, 0}})};
  Report report;
  EXPECT_EQ(plan(f, std::vector<Profile>(1), report).bridges[0].axis, (std::vector<Vec3>{{0, 0, 0}, {30, 0, 0}}));
}

TEST(Plan, SortsById) {
  map::Features f;
  for (const std::int64_t id : {5, 3, 9, 1}) f.tracks.push_back(track(id, Passage::kBridge, {{0, 0}, {30, 0}}));
  Report report;
  const Structures s = plan(f, std::vector<Profile>(4), report);
  EXPECT_TRUE(std::ranges::is_sorted(s.bridges, {}, &Span::id));
  EXPECT_EQ(s.bridges.size(), 4u);
}

}  // namespace
}  // namespace citykiln::structures
