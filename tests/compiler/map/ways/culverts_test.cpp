#include "compiler/map/ways/culverts.h"

#include <gtest/gtest.h>

#include "compiler/geometry/polygon.h"

namespace citykiln::map {
namespace {

Landform dam_across(double x) {
  return {.id = {{OsmType::kWay, 9}, 0},
          .axis = {{x, -40}, {x, 40}},
          .kind = LandformKind::kDam,
          .height_m = 10,
          .width_m = 4};
}

Waterway stream(Polyline axis) { return {.id = {{OsmType::kWay, 1}, 0}, .axis = std::move(axis), .width_m = 2}; }

TEST(WithCulverts, LeadAStreamThroughADam) {
  const auto parts = with_culverts({stream({{-100, 0}, {0, 0}, {100, 0}})}, std::vector{dam_across(0)});
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_EQ(parts[0].passage, Passage::kGround);
  EXPECT_EQ(parts[1].passage, Passage::kTunnel);
  EXPECT_EQ(parts[2].passage, Passage::kGround);
  // 2 m of the top and 10 m of the slope on each side
  EXPECT_NEAR(parts[1].axis.front().x, -12, 0.5);
  EXPECT_NEAR(parts[1].axis.back().x, 12, 0.5);
  for (std::size_t i = 0; i < parts.size(); ++i) EXPECT_EQ(parts[i].id.part, i);
  for (std::size_t i = 1; i < parts.size(); ++i) EXPECT_EQ(parts[i].axis.front(), parts[i - 1].axis.back());
  EXPECT_EQ(parts.front().axis.front(), Vec2(-100, 0));
  EXPECT_EQ(parts.back().axis.back(), Vec2(100, 0));
}

TEST(WithCulverts, AStreamBesideADamStays) {
  const auto parts = with_culverts({stream({{3, -100}, {3, 100}})}, std::vector{dam_across(0)});
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].passage, Passage::kGround);
}

TEST(WithCulverts, AStreamThatEndsInADamEndsUnderground) {
  const auto parts = with_culverts({stream({{-100, 0}, {1, 0}})}, std::vector{dam_across(0)});
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[1].passage, Passage::kTunnel);
  EXPECT_EQ(parts[1].axis.back(), Vec2(1, 0));
}

TEST(WithCulverts, TwoDamsOfOneFootShareACulvert) {
  const auto parts =
      with_culverts({stream({{-100, 0}, {100, 0}})}, std::vector{dam_across(0), dam_across(15), dam_across(70)});
  ASSERT_EQ(parts.size(), 5u);
  EXPECT_NEAR(length_m(parts[1].axis), 39, 1.1);
}

TEST(WithCulverts, AWallOrAPierLetsTheStreamBe) {
  Landform weir = dam_across(0);
  weir.kind = LandformKind::kDeck;
  EXPECT_EQ(with_culverts({stream({{-100, 0}, {100, 0}})}, std::vector{weir}).size(), 1u);
}

}  // namespace
}  // namespace citykiln::map
