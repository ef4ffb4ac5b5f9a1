#include "compiler/ground/profiles/smoothing/grade_limits.h"

#include <gtest/gtest.h>

#include "compiler/ground/profiles/graph/grade_rules.h"
#include "tests/compiler/ground/profiles/made_network.h"

namespace citykiln::ground {
namespace {

struct StraightRoad {
  map::Features features;
  std::vector<roads::Road> roads;
  ProfileGraph graph;

  explicit StraightRoad(double half_m) {
    features.tracks = {track(1, {{-half_m, 0}, {half_m, 0}})};
    Report report;
    roads = roads::roads_on_ground(features, report);
    graph = graph_of(features, roads, {});
  }

  std::vector<double> heights(const std::function<double(double)>& height_m) const {
    std::vector<double> z_m;
    for (const GraphNode& node : graph.nodes) z_m.push_back(height_m(node.at.x));
    return z_m;
  }
};

TEST(GradeLimits, NothingBeyondTheirReachChangesABit) {
  const StraightRoad line(4096);
  // too steep everywhere
  const auto z_m = line.heights([](double x) { return x * 0.3; });
  const auto other_m =
      line.heights([](double x) { return x * 0.3 + (x > kGradeInfluence_m + 16 ? (x - 528) * 0.4 : 0); });
  const auto one = limit_grades(line.graph, z_m), two = limit_grades(line.graph, other_m);
  for (std::size_t n = 0; n < one.size(); ++n)
    ASSERT_TRUE(line.graph.nodes[n].at.x > 0 || one[n] == two[n]) << line.graph.nodes[n].at.x;
  EXPECT_NE(one, two);
}

TEST(GradeLimits, CutAndFillAlike) {
  const StraightRoad line(1000);
  const double limit = grade_rule_of(map::LandCoverClass::kResidentialRoad).limit;
  const auto step_m = line.heights([](double x) { return x > 0 ? 106 : 100; });
  const auto limited = limit_grades(line.graph, step_m);
  for (const Leg& leg : line.graph.legs) EXPECT_LE(leg.length_m, kStation_m);
  double below = 0, above = 0;
  for (std::uint32_t n = 0; n < limited.size(); ++n) {
    above = std::max(above, limited[n] - step_m[n]), below = std::max(below, step_m[n] - limited[n]);
    for (const Leg& leg : line.graph.legs_of(n))
      EXPECT_LE(std::abs(limited[n] - limited[leg.to]), limit * leg.length_m + 1e-9);
  }
  EXPECT_NEAR(above, below, 1e-9);
  EXPECT_LT(above, 3.001);
}

TEST(GradeLimits, NothingMovesFartherThanAllowedAndNothingBreaksOff) {
  const StraightRoad line(4096);
  const auto z_m = line.heights([](double x) { return std::abs(x) < 700 ? x * 0.5 : x > 0 ? 350 : -350; });
  const auto limited = limit_grades(line.graph, z_m);
  ASSERT_GT(limited.size(), 100u);
  for (std::uint32_t n = 0; n < limited.size(); ++n) {
    EXPECT_LE(std::abs(limited[n] - z_m[n]), kMaxEarthwork_m / 2);
    for (const Leg& leg : line.graph.legs_of(n)) EXPECT_LE(std::abs(limited[n] - limited[leg.to]), 0.6 * leg.length_m);
  }
}

TEST(GradeLimits, OnlyStreetsMayBeSteeperWhereTheyAreAllowedTo) {
  for (const auto surface : {map::LandCoverClass::kResidentialRoad, map::LandCoverClass::kRailway}) {
    StraightRoad line(1000);
    line.features.tracks[0].surface = surface;
    const double limit = grade_rule_of(surface).limit;
    const auto z_m =
        line.heights([&](double x) { return 1.25 * limit * std::abs(x) / 2 + (x > 0 ? limit * x / 2 : 0); });
    std::vector<double> steepness;
    for (const GraphNode& node : line.graph.nodes) steepness.push_back(node.at.x > 0 ? 1.5 : 1);
    ASSERT_FALSE(z_m.empty());
    const bool is_rail = surface == map::LandCoverClass::kRailway;
    EXPECT_EQ(limit_grades(line.graph, z_m, steepness) == z_m, !is_rail);
    EXPECT_NE(limit_grades(line.graph, z_m), z_m);
  }
}

TEST(GradeLimits, WhatKeepsThemStays) {
  const StraightRoad line(1000);
  const auto z_m = line.heights([](double x) { return 0.17 * std::abs(x); });
  EXPECT_EQ(limit_grades(line.graph, z_m), z_m);
}

}  // namespace
}  // namespace citykiln::ground
