#include "compiler/buildings/planning/vertical_support.h"

#include <gtest/gtest.h>

namespace citykiln::buildings {
namespace {

map::Footprint raised_block(double x, double size, double min_height_m, double height_m) {
  map::Footprint f;
  f.id = {{OsmType::kWay, static_cast<std::int64_t>(x)}, 0};
  f.polygon.outer = {{x, 0}, {x + size, 0}, {x + size, size}, {x, size}};
  f.min_height_m = min_height_m, f.height_m = height_m;
  return f;
}

std::vector<bool> supported(const std::vector<map::Footprint>& footprints) {
  return find_supported(footprints, shared_walls(footprints));
}

TEST(FindSupported, FootprintsOnTheGroundAre) {
  EXPECT_EQ(supported(std::vector{raised_block(0, 20, 0, 9)}), std::vector{true});
}

TEST(FindSupported, AnUpperStoreyNeedsALowerOne) {
  const map::Footprint upper = raised_block(0, 20, 9, 18);
  EXPECT_EQ(supported(std::vector{upper}), std::vector{false});
  EXPECT_EQ(supported(std::vector{upper, raised_block(0, 20, 0, 9)}), (std::vector{true, true}));
  // storeys are guessed, but not by so much
  EXPECT_EQ(supported(std::vector{upper, raised_block(0, 20, 0, 6)}), (std::vector{true, true}));
  EXPECT_EQ(supported(std::vector{upper, raised_block(0, 20, 0, 3)}), (std::vector{false, true}));
}

TEST(FindSupported, AHallStandsOnThinColumns) {
  map::Footprint column = raised_block(9.3, 0.5, 0, 9);
  for (Vec2& p : column.polygon.outer) p.y += 9.3;
  EXPECT_EQ(supported(std::vector{raised_block(0, 20, 9, 11), column}), (std::vector{true, true}));
  // beside it
  for (Vec2& p : column.polygon.outer) p.y += 20;
  EXPECT_EQ(supported(std::vector{raised_block(0, 20, 9, 11), column}), (std::vector{false, true}));
}

TEST(FindSupported, RoofsAndHighPartsNeedSupportToo) {
  map::Footprint roof = raised_block(0, 20, 4, 5);
  roof.is_open = true;
  EXPECT_EQ(supported(std::vector{roof}), std::vector{false});
  EXPECT_EQ(supported(std::vector{raised_block(0, 5, 37, 41)}), std::vector{false});
}

TEST(FindSupported, TheLowestOfAStackSupportsTheOthers) {
  const std::vector stack{raised_block(0, 20, 9, 12), raised_block(0, 18, 12, 15), raised_block(0, 10, 15, 30)};
  EXPECT_EQ(supported(stack), (std::vector{false, true, true}));
}

TEST(FindSupported, OutlinesWithPartsSupportNothing) {
  map::Footprint outline = raised_block(0, 20, 0, 18);
  outline.has_parts = true;
  EXPECT_EQ(supported(std::vector{raised_block(0, 20, 9, 18), outline}), (std::vector{false, true}));
}

TEST(FindSupported, ABridgeBetweenHousesIsSupportedByThem) {
  // wall to wall
  const std::vector houses{raised_block(0, 20, 0, 15), raised_block(20, 10, 6, 9), raised_block(30, 20, 0, 15)};
  EXPECT_EQ(supported(houses), (std::vector{true, true, true}));
  const std::vector hall{raised_block(0, 20, 0, 15), raised_block(20, 20, 6, 9)};
  EXPECT_EQ(supported(hall), (std::vector{true, false}));
  const std::vector between{raised_block(0, 20, 0, 15), raised_block(20, 20, 6, 9), raised_block(40, 20, 0, 15)};
  EXPECT_EQ(supported(between), (std::vector{true, true, true}));
}

}  // namespace
}  // namespace citykiln::buildings
