#include "compiler/contract/detail_tolerances.h"

#include <gtest/gtest.h>

namespace citykiln {
namespace {

TEST(DetailTolerances, RangesBeginInclusiveAndEndExclusive) {
  EXPECT_TRUE(has_detail(Detail::kRoadSurfaces, 0.2499));
  EXPECT_FALSE(has_detail(Detail::kRoadSurfaces, 0.25));
  EXPECT_FALSE(has_detail(Detail::kFacadeTextures, 0.4999));
  EXPECT_TRUE(has_detail(Detail::kFacadeTextures, 0.5));
  EXPECT_TRUE(has_detail(Detail::kWoodCanopies, 1e6));
}

TEST(DetailTolerances, LimitsMadeByJustAboveAreInclusive) {
  EXPECT_TRUE(has_detail(Detail::kGrassBlades, 0.05));
  EXPECT_FALSE(has_detail(Detail::kGrassBlades, just_above(0.05)));
}

TEST(DetailTolerances, BlocksBeginWhereFacadeTexturesEnd) {
  EXPECT_EQ(tolerances_with(Detail::kBlocks).from_m, tolerances_with(Detail::kFacadeTextures).below_m);
}

TEST(DetailTolerances, HedgePlantsAndRoadSurfacesHaveOneLimitForTheLevelsThatShareThem) {
  EXPECT_EQ(tolerances_with(Detail::kHedgePlants).below_m, tolerances_with(Detail::kRoadSurfaces).below_m);
}

}  // namespace
}  // namespace citykiln
