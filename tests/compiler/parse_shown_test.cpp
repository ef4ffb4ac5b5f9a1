#include "compiler/parse_shown.h"

#include <gtest/gtest.h>

namespace citykiln {
namespace {

using scene::SceneLayer;

TEST(ParseShown, KeepsTheLayersOfAListAlone) {
  const auto left_out = parse_layers("ground,roads");
  ASSERT_TRUE(left_out);
  for (int i = 0; i < static_cast<int>(SceneLayer::kCount); ++i) {
    const auto layer = static_cast<SceneLayer>(i);
    EXPECT_EQ(has(*left_out, layer), layer != SceneLayer::kGround && layer != SceneLayer::kRoads) << name_of(layer);
  }
}

TEST(ParseShown, LeavesOutLayersWithASign) {
  EXPECT_EQ(*parse_layers("-plants,-yards"), bit_of(SceneLayer::kPlants) | bit_of(SceneLayer::kYards));
  EXPECT_EQ(*parse_layers("all"), scene::kNoLayers);
  EXPECT_EQ(*parse_layers("all,-water"), bit_of(SceneLayer::kWater));
}

TEST(ParseShown, RejectsUnknownLayersAndAnEmptyTile) {
  EXPECT_FALSE(parse_layers("trees"));
  EXPECT_FALSE(parse_layers("roads,-roads"));
  EXPECT_FALSE(parse_layers(""));
}

TEST(ParseShown, LimitsDensitiesAndShares) {
  EXPECT_EQ(*parse_wood_density("0.5"), 0.5);
  EXPECT_FALSE(parse_wood_density("4.1"));
  EXPECT_FALSE(parse_wood_density("-1"));
  EXPECT_EQ(*parse_lit_windows("none"), std::optional<double>(0));
  EXPECT_EQ(*parse_lit_windows("usual"), std::nullopt);
  EXPECT_FALSE(parse_lit_windows("2"));
  EXPECT_EQ(*parse_lamps("on"), scene::LampLight::kOn);
  EXPECT_FALSE(parse_lamps("maybe"));
}

}  // namespace
}  // namespace citykiln
