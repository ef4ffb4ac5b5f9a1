#include "compiler/ground/profiles/smoothing/profile_knots.h"

#include <gtest/gtest.h>

#include "tests/compiler/ground/profiles/made_network.h"

namespace citykiln::ground {
namespace {

struct LongRoad {
  map::Features features;
  std::vector<roads::Road> roads;
  ProfileGraph graph;

  LongRoad() {
    features.tracks = {track(1, {{0, 0}, {8192, 0}})};
    Report report;
    roads = roads::roads_on_ground(features, report);
    graph = graph_of(features, roads, {});
  }

  Profile knots(const std::function<double(double)>& height_m) const {
    JunctionPlanes planes{{}, std::vector<Vec2>(graph.nodes.size())};
    for (const GraphNode& node : graph.nodes) planes.z_m.push_back(height_m(node.at.x));
    return knots_of(graph, graph.ways.front(), planes);
  }
};

std::vector<Knot> knots_before(const Profile& profile, double at_m) {
  const std::span<const Knot> knots = between(profile, 0, at_m);
  return {knots.begin(), knots.end()};
}

// Regions of a plan have no heights far away. On waves so low few stations are knots, and both ends of a stretch decide
// which.
TEST(ProfileKnots, DependOnNoHeightsBeyondAStretch) {
  const LongRoad road;
  const auto bump_m = [](double x) { return 0.012 * std::sin(x / 97) + 0.008 * std::sin(x / 41); };
  const auto other_m = [&](double x) { return bump_m(x) + (x > 2000 + kKnotStretch_m ? (x - 3024) * 0.2 : 0); };
  EXPECT_EQ(knots_before(road.knots(bump_m), 2000), knots_before(road.knots(other_m), 2000));
  EXPECT_NE(road.knots(bump_m), road.knots(other_m));
}

}  // namespace
}  // namespace citykiln::ground
