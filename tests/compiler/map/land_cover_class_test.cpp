#include "compiler/map/land_cover_class.h"

#include <gtest/gtest.h>

#include <set>

namespace citykiln::map {
namespace {

constexpr auto kCount = static_cast<std::size_t>(LandCoverClass::kCount);

TEST(LandCoverClass, KnowsAtLeast42KindsOfAreaIn12Groups) {
  std::set<LandCoverGroup> groups;
  int kinds = 0;
  for (std::size_t i = 0; i < kCount; ++i) {
    const LandCoverGroup group = values_of(static_cast<LandCoverClass>(i)).group;
    if (group == LandCoverGroup::kUnknown || group >= LandCoverGroup::kRoad) continue;
    ++kinds;
    groups.insert(group);
  }
  EXPECT_GE(kinds, 42);
  EXPECT_EQ(groups.size(), 12u);
}

TEST(LandCoverClass, UnknownIsFirstAndHasTheLowestPriority) {
  EXPECT_EQ(static_cast<int>(LandCoverClass::kUnknown), 0);
  for (std::size_t i = 1; i < kCount; ++i)
    EXPECT_GT(values_of(static_cast<LandCoverClass>(i)).priority, values_of(LandCoverClass::kUnknown).priority);
}

TEST(LandCoverClass, NamesAreUnique) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < kCount; ++i)
    EXPECT_TRUE(names.insert(values_of(static_cast<LandCoverClass>(i)).name).second);
}

TEST(LandCoverClass, HigherObjectsHaveHigherPriority) {
  const auto priority = [](LandCoverClass surface) { return values_of(surface).priority; };
  const LandCoverClass upwards[] = {LandCoverClass::kSea,         LandCoverClass::kResidential,
                                    LandCoverClass::kForest,      LandCoverClass::kLake,
                                    LandCoverClass::kParking,     LandCoverClass::kFootPath,
                                    LandCoverClass::kServiceRoad, LandCoverClass::kMotorwayRoad,
                                    LandCoverClass::kPier,        LandCoverClass::kBuilding};
  for (std::size_t i = 0; i + 1 < std::size(upwards); ++i)
    EXPECT_LT(priority(upwards[i]), priority(upwards[i + 1])) << i;
}

}  // namespace
}  // namespace citykiln::map
