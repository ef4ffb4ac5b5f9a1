#include "compiler/map/surface_class.h"

#include <gtest/gtest.h>

#include <set>

namespace citykiln::map {
namespace {

constexpr auto kCount = static_cast<std::size_t>(SurfaceClass::kCount);

TEST(SurfaceClass, KnowsAtLeast42KindsOfAreaIn12Groups) {
  std::set<SurfaceGroup> groups;
  int kinds = 0;
  for (std::size_t i = 0; i < kCount; ++i) {
    const SurfaceGroup group = values_of(static_cast<SurfaceClass>(i)).group;
    if (group == SurfaceGroup::kUnknown || group >= SurfaceGroup::kRoad) continue;
    ++kinds;
    groups.insert(group);
  }
  EXPECT_GE(kinds, 42);
  EXPECT_EQ(groups.size(), 12u);
}

TEST(SurfaceClass, UnknownComesFirstAndYieldsToAll) {
  EXPECT_EQ(static_cast<int>(SurfaceClass::kUnknown), 0);
  for (std::size_t i = 1; i < kCount; ++i)
    EXPECT_GT(values_of(static_cast<SurfaceClass>(i)).priority, values_of(SurfaceClass::kUnknown).priority);
}

TEST(SurfaceClass, NamesAreUnique) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < kCount; ++i)
    EXPECT_TRUE(names.insert(values_of(static_cast<SurfaceClass>(i)).name).second);
}

TEST(SurfaceClass, WhatStandsOnTopWins) {
  const auto priority = [](SurfaceClass surface) { return values_of(surface).priority; };
  const SurfaceClass upwards[] = {SurfaceClass::kSea,         SurfaceClass::kResidential,  SurfaceClass::kForest,
                                  SurfaceClass::kLake,        SurfaceClass::kParking,      SurfaceClass::kFootPath,
                                  SurfaceClass::kServiceRoad, SurfaceClass::kMotorwayRoad, SurfaceClass::kPier,
                                  SurfaceClass::kBuilding};
  for (std::size_t i = 0; i + 1 < std::size(upwards); ++i)
    EXPECT_LT(priority(upwards[i]), priority(upwards[i + 1])) << i;
}

}  // namespace
}  // namespace citykiln::map
