#include "compiler/bake/bounds.h"

#include <gtest/gtest.h>

#include "compiler/plants/species.h"

namespace citykiln::bake {
namespace {

TEST(Bounds, OfAPlantContainTheWidestCrown) {
  const Bounds bounds = bounds_of(Placement{.at = {100, -50, 7}, .scale = 8});
  const double reach_m = plants::kWidestCrown / 2 * 8;
  EXPECT_TRUE(bounds.plan.contains({100 + reach_m, -50 - reach_m}));
  EXPECT_TRUE(bounds.plan.contains({100 - reach_m, -50 + reach_m}));
  EXPECT_EQ(bounds.low_m, 7);
  EXPECT_EQ(bounds.high_m, 15);
}

}  // namespace
}  // namespace citykiln::bake
