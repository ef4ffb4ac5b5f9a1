#include "compiler/ground/profiles/smoothing/smooth_profile.h"

#include <gtest/gtest.h>

#include "tests/compiler/ground/profiles/made_network.h"

namespace citykiln::ground {
namespace {

struct ObliqueRoad {
  map::Features features;
  std::vector<roads::Road> roads;
  ProfileGraph graph;

  explicit ObliqueRoad(double half_m) {
    features.tracks = {track(1, {{-half_m, 5}, {half_m, 11}})};
    Report report;
    roads = roads::roads_on_ground(features, report);
    graph = graph_of(features, roads, {});
  }
};

TEST(SmoothProfile, NothingBeyondItsReachChangesABit) {
  const ObliqueRoad line(4096);
  const RandomSequence draw(1, StableId{1}, "data");
  std::vector<double> data_m, other_m;
  for (std::uint32_t n = 0; n < line.graph.nodes.size(); ++n) {
    data_m.push_back(draw.between(0, 30, n));
    other_m.push_back(line.graph.nodes[n].at.x > kSmoothRadius_m ? draw.between(0, 9000, n) : data_m.back());
  }
  const auto one = smooth_heights(line.graph, data_m, 64), two = smooth_heights(line.graph, other_m, 64);
  for (std::size_t n = 0; n < one.size(); ++n)
    ASSERT_TRUE(line.graph.nodes[n].at.x > 0 || one[n] == two[n]) << line.graph.nodes[n].at.x;
  EXPECT_NE(one, two);
}

TEST(SmoothProfile, LeavesALevelAndASlopeAlone) {
  const ObliqueRoad line(1500);
  for (const double slope : {0.0, 0.07}) {
    std::vector<double> data_m;
    for (const GraphNode& node : line.graph.nodes) data_m.push_back(200 + slope * node.at.x);
    const auto smooth_m = smooth_heights(line.graph, data_m, 64);
    ASSERT_FALSE(data_m.empty());
    for (std::size_t n = 0; n < data_m.size(); ++n) EXPECT_NEAR(smooth_m[n], data_m[n], 1e-6);
  }
}

}  // namespace
}  // namespace citykiln::ground
