#include "compiler/structures/plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "compiler/geometry/snap.h"
#include "compiler/structures/deck_graph.h"
#include "compiler/structures/deck_heights.h"

namespace citykiln::structures {
namespace {

using map::Passage;

// Heights of a function of the plane, on a grid of 8 m from (-256, -256) to (256, 256).
map::Heightfield field_of(const std::function<double(double, double)>& height_m) {
  map::Heightfield field{{-256, -256}, 8, 65, 65, {}, 0};
  for (int j = 0; j < 65; ++j)
    for (int i = 0; i < 65; ++i)
      field.heights.push_back(static_cast<std::int32_t>(height_m(-256 + i * 8, -256 + j * 8) / map::kHeightQuantum_m));
  return field;
}

map::Track track(std::int64_t id, Passage passage, Polyline axis, std::vector<std::int64_t> nodes, int layer = 1) {
  map::Track t;
  t.id = {{OsmType::kWay, id}, 0};
  t.axis = std::move(axis);
  t.node_ids = std::move(nodes);
  t.surface = map::SurfaceClass::kResidentialRoad;
  t.section = {{{map::LaneKind::kDriving, map::LaneWay::kBoth, 6}}, 3};
  t.layer = static_cast<std::int8_t>(layer);
  t.passage = passage;
  return t;
}

// A bridge from a.x to b.x along the x axis between two roads of the ground.
map::Features bridged(double from, double to, int layer = 1) {
  map::Features f;
  f.tracks = {track(1, Passage::kGround, {{from - 50, 0}, {from, 0}}, {1, 2}),
              track(2, Passage::kBridge, {{from, 0}, {to, 0}}, {2, 3}, layer),
              track(3, Passage::kGround, {{to, 0}, {to + 50, 0}}, {3, 4})};
  return f;
}

double height_at(const Span& span, double x) {
  for (std::size_t i = 1; i < span.axis.size(); ++i) {
    const Vec3 a = span.axis[i - 1], b = span.axis[i];
    if (a.x <= x && x <= b.x) return a.z + (b.z - a.z) * (x - a.x) / (b.x - a.x);
  }
  return -1;
}

TEST(Plan, AnchorsBridgesAtTheGround) {
  Report report;
  const auto field = field_of([](double x, double) { return 100 + x / 16; });
  const Structures s = plan(bridged(-96, 96), field, report);
  ASSERT_EQ(s.bridges.size(), 1u);
  EXPECT_EQ(s.bridges[0].axis.front(), (Vec3{-96, 0, 94}));
  EXPECT_EQ(s.bridges[0].axis.back(), (Vec3{96, 0, 106}));
  EXPECT_EQ(report.counts().count(Code::kBridgeWithoutGround), 0u);
}

TEST(Plan, LeavesShortBridgesFlat) {
  Report report;
  const Structures s = plan(bridged(-8, 8), field_of([](double, double) { return 50; }), report);
  ASSERT_EQ(s.bridges[0].axis.size(), 2u);
  for (const Vec3 p : s.bridges[0].axis) EXPECT_EQ(p.z, 50);
}

TEST(Plan, RisesLongBridgesToTheirClearanceAndNoSteeperThanTheGrade) {
  Report report;
  for (const int layer : {0, 1, 2}) {
    const Structures s = plan(bridged(-240, 240, layer), field_of([](double, double) { return 0; }), report);
    const Span& span = s.bridges[0];
    EXPECT_NEAR(height_at(span, 0), kClearance_m * std::max(layer, 1), 0.02);
    EXPECT_NEAR(height_at(span, -240 + kLevelEnd_m), 0, 0.02);
    for (std::size_t i = 1; i < span.axis.size(); ++i) {
      const double run = span.axis[i].x - span.axis[i - 1].x, rise = std::abs(span.axis[i].z - span.axis[i - 1].z);
      EXPECT_LE(rise, kBridgeGrade * run + 0.002);
    }
    // straight pieces keep no stations: two ends, two feet, two tops, and what a foot between stations adds
    EXPECT_LE(span.axis.size(), 10u);
  }
}

TEST(Plan, DoesNotRiseWhereTheGroundFallsAway) {
  Report report;
  const auto valley = field_of([](double x, double) { return std::abs(x) > 90 ? 40 : 10; });
  const Structures s = plan(bridged(-100, 100), valley, report);
  for (const Vec3 p : s.bridges[0].axis) EXPECT_NEAR(p.z, 40, 0.2);
}

TEST(Plan, RunsStraightOverNodesThatOnlyBridgesShare) {
  Report report;
  map::Features f;
  f.tracks = {
      track(1, Passage::kGround, {{-50, 9}, {-20, 0}}, {1, 2}), track(2, Passage::kBridge, {{-20, 0}, {-5, 0}}, {2, 3}),
      track(3, Passage::kBridge, {{-5, 0}, {20, 0}}, {3, 4}), track(4, Passage::kGround, {{20, 0}, {60, 0}}, {4, 5})};
  const auto field = field_of([](double x, double) { return x < -15 ? 30 : x > 15 ? 34 : 0; });
  const Structures s = plan(f, field, report);
  EXPECT_EQ(s.bridges[0].axis.back(), s.bridges[1].axis.front());
  EXPECT_NEAR(s.bridges[0].axis.back().z, 30 + 4 * 15 / 40.0, 0.001);
}

TEST(Plan, EndsAtGroundHeightWhereABridgeMeetsNothing) {
  Report report;
  map::Features f;
  f.tracks = {track(1, Passage::kBridge, {{0, 0}, {30, 0}}, {1, 2})};
  const Structures s = plan(f, field_of([](double, double) { return 7; }), report);
  EXPECT_EQ(s.bridges[0].axis.front().z, 7);
  EXPECT_EQ(report.counts()[Code::kBridgeWithoutGround], 2u);
}

TEST(Plan, KeepsTunnelsStraightBetweenTheirEnds) {
  Report report;
  map::Features f;
  f.tracks = {track(9, Passage::kTunnel, {{-100, 0}, {0, 0}, {100, 0}}, {1, 2, 3}, -1)};
  const auto mountain = field_of([](double x, double) { return 200 - std::abs(x) + (x > 0 ? x / 8 : 0); });
  const Structures s = plan(f, mountain, report);
  ASSERT_EQ(s.tunnels.size(), 1u);
  EXPECT_NEAR(s.tunnels[0].axis[1].z, (s.tunnels[0].axis[0].z + s.tunnels[0].axis[2].z) / 2, 0.001);
  EXPECT_EQ(report.counts()[Code::kTunnelNotMeshed], 1u);
}

TEST(Plan, DoesNotDependOnTheOrderOfTracksAndBalances) {
  map::Features f;
  for (int k = 0; k < 12; ++k)
    f.tracks.push_back(track(k + 1, k % 3 == 0 ? Passage::kGround : Passage::kBridge,
                             {{k * 20.0 - 120, 0}, {k * 20.0 - 110, 5.0 * (k % 2)}, {k * 20.0 - 100, 0}},
                             {2 * k, 2 * k + 1, 2 * k + 2}));
  const auto field = field_of([](double x, double y) { return 20 + x / 32 + y / 4; });
  Report one, two;
  const Structures a = plan(f, field, one);
  std::reverse(f.tracks.begin(), f.tracks.end());
  const Structures b = plan(f, field, two);
  EXPECT_EQ(a.bridges, b.bridges);
  EXPECT_EQ(a.bridges.size(), 8u);
  EXPECT_TRUE(one.balances());
  EXPECT_EQ(one.ledger().at("structures/bridge").in, 8u);
}

TEST(Plan, PutsEveryPointOnTheGrid) {
  Report report;
  const Structures s = plan(bridged(-93.5, 77.25), field_of([](double x, double y) { return x / 7 + y / 3; }), report);
  for (const Vec3 p : s.bridges[0].axis) EXPECT_EQ(p, snapped(p));
}

}  // namespace
}  // namespace citykiln::structures
