#include "compiler/fields/field_barriers.h"

#include <gtest/gtest.h>

namespace citykiln::fields {
namespace {

constexpr FieldBoundary kBorder{{0, 0}, {200, 0}, 7};
constexpr ObjectId kLand{{OsmType::kWay, 1}, 0};

std::vector<map::Barrier> hedges_where(const IsFree& is_free) {
  return barriers_on(kBorder, FieldBorder::kHedge, kLand, is_free, RandomSequence(1, StableId{2}, "border"));
}

TEST(FieldBarriers, LeaveAnOpeningForMachines) {
  const std::vector<map::Barrier> hedges = hedges_where([](Vec2) { return true; });
  ASSERT_EQ(hedges.size(), 2u);
  const double gate_m = hedges[1].axis.front().x - hedges[0].axis.back().x;
  EXPECT_NEAR(gate_m, kGate_m, 0.02);
  EXPECT_EQ(hedges[0].axis.front(), (Vec2{0, 0}));
  EXPECT_EQ(hedges[1].axis.back(), (Vec2{200, 0}));
  EXPECT_NE(hedges[0].id, hedges[1].id);
}

TEST(FieldBarriers, StandOnFreeStretchesAlone) {
  for (const map::Barrier& hedge : hedges_where([](Vec2 at) { return at.x > 40 && (at.x < 60 || at.x > 180); })) {
    EXPECT_GT(hedge.axis.front().x, 40);
    EXPECT_GE(distance(hedge.axis.front(), hedge.axis.back()), kShortestBarrier_m);
  }
  EXPECT_TRUE(hedges_where([](Vec2 at) { return at.x < kShortestBarrier_m - 3; }).empty()) << "too short";
}

}  // namespace
}  // namespace citykiln::fields
