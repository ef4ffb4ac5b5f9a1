#include "compiler/ground/plan.h"

#include <gtest/gtest.h>

#include "compiler/geometry/snap.h"

namespace citykiln::ground {
namespace {

TEST(PlanStreams, SidesAreOnTheGridAndTogetherAsWideAsTheWater) {
  map::Features features;
  // an odd number of quanta, an even one, and the least
  for (const double width_m : {3 * kQuantum_m + 2, 5.5, kQuantum_m}) {
    map::Waterway water;
    water.id = {{OsmType::kWay, static_cast<std::int64_t>(features.waterways.size()) + 1}, 0};
    water.axis = {{0, 0}, {9, 1}};
    water.width_m = width_m;
    features.waterways.push_back(water);
  }
  Report report;
  const std::vector<roads::Strip> streams = plan_streams(features, report);
  ASSERT_EQ(streams.size(), 3u);
  for (std::size_t i = 0; i < streams.size(); ++i) {
    EXPECT_EQ(streams[i].left_m, snapped(streams[i].left_m));
    EXPECT_EQ(streams[i].right_m, snapped(streams[i].right_m));
    EXPECT_EQ(streams[i].left_m + streams[i].right_m, features.waterways[i].width_m);
    EXPECT_EQ(streams[i].surface, i == 1 ? map::LandCoverClass::kRiver : map::LandCoverClass::kStream);
  }
}

}  // namespace
}  // namespace citykiln::ground
