#include "compiler/bake/ground/wild_cover.h"

#include <gtest/gtest.h>

namespace citykiln::bake {
namespace {

using climate::ClimateClass;
using climate::ClimateMix;
using materials::Material;

// The normal of a slope along x, of this rise in metres per metre.
Vec3 normal_rising(double rise) { return unit(Vec3{-rise, 0, 1}); }

TEST(WildCover, IsScrubUpToTheTreeLineAndMeadowAboveIt) {
  for (const ClimateClass climate : {ClimateClass::kCfb, ClimateClass::kCsa, ClimateClass::kDfb, ClimateClass::kAf}) {
    EXPECT_EQ(wild_material(ClimateMix(climate), 100), Material::kScrub);
    EXPECT_EQ(wild_material(ClimateMix(climate), 2600), Material::kMeadow);
  }
}

TEST(WildCover, IsNothingInDesertsAndUnderIce) {
  for (const ClimateClass climate : {ClimateClass::kBWh, ClimateClass::kBWk, ClimateClass::kEF})
    EXPECT_EQ(wild_material(ClimateMix(climate), 100), std::nullopt);
}

TEST(WildCover, BeginsAtAbout25Degrees) {
  for (int i = 0; i < 200; ++i) {
    const Vec3 at{7.0 * i, 3.0 * i, 0};
    EXPECT_FALSE(is_wild(normal_rising(0.36), at, 1));  // 20 degrees
    EXPECT_TRUE(is_wild(normal_rising(0.58), at, 1));   // 30 degrees
  }
}

TEST(WildCover, HasMoreRockTheSteeperItIs) {
  const auto rocks = [](double rise) {
    int count = 0;
    for (int i = 0; i < 500; ++i) count += is_bare_rock(normal_rising(rise), {7.0 * i, 3.0 * i, 0}, 1);
    return count;
  };
  EXPECT_EQ(rocks(0.6), 0);                // 31 degrees
  EXPECT_GT(rocks(0.9), 10);               // 42 degrees
  EXPECT_GT(rocks(1.1), rocks(0.9) + 50);  // 48 degrees
}

}  // namespace
}  // namespace citykiln::bake
