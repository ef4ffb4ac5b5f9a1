#include "compiler/buildings/vertical_support.h"

#include <gtest/gtest.h>

#include "compiler/map/buildings/building_classes.h"

namespace citykiln::buildings {
namespace {

map::Footprint raised_block(double x, double size, double min_height_m, double height_m) {
  map::Footprint f;
  f.id = {{OsmType::kWay, static_cast<std::int64_t>(x)}, 0};
  f.polygon.outer = {{x, 0}, {x + size, 0}, {x + size, size}, {x, size}};
  f.min_height_m = min_height_m, f.height_m = height_m;
  return f;
}

map::Track path_along_y(double x) {
  map::Track track;
  track.axis = {{x, -50}, {x, 50}};
  return track;
}

std::vector<bool> supported(const std::vector<map::Footprint>& footprints, const std::vector<map::Track>& tracks) {
  return find_supported(footprints, shared_walls(footprints), tracks);
}

TEST(FindSupported, FootprintsOnTheGroundAre) {
  EXPECT_EQ(supported(std::vector{raised_block(0, 20, 0, 9)}, {}), std::vector{true});
}

TEST(FindSupported, AnUpperStoreyNeedsALowerOne) {
  const map::Footprint upper = raised_block(0, 20, 9, 18);
  EXPECT_EQ(supported(std::vector{upper}, {}), std::vector{false});
  EXPECT_EQ(supported(std::vector{upper, raised_block(0, 20, 0, 9)}, {}), (std::vector{true, true}));
  // storeys are guessed, but not by so much
  EXPECT_EQ(supported(std::vector{upper, raised_block(0, 20, 0, 6)}, {}), (std::vector{true, true}));
  EXPECT_EQ(supported(std::vector{upper, raised_block(0, 20, 0, 3)}, {}), (std::vector{false, true}));
}

TEST(FindSupported, AHallStandsOnThinColumns) {
  map::Footprint column = raised_block(9.3, 0.5, 0, 9);
  for (Vec2& p : column.polygon.outer) p.y += 9.3;
  EXPECT_EQ(supported(std::vector{raised_block(0, 20, 9, 11), column}, {}), (std::vector{true, true}));
  // beside it
  for (Vec2& p : column.polygon.outer) p.y += 20;
  EXPECT_EQ(supported(std::vector{raised_block(0, 20, 9, 11), column}, {}), (std::vector{false, true}));
}

TEST(FindSupported, HighPartsMayFloat) {
  EXPECT_EQ(supported(std::vector{raised_block(0, 5, 37, 41)}, {}), std::vector{true});
}

TEST(FindSupported, TheLowestOfAStackSupportsTheOthers) {
  const std::vector stack{raised_block(0, 20, 9, 12), raised_block(0, 18, 12, 15), raised_block(0, 10, 15, 30)};
  EXPECT_EQ(supported(stack, {}), (std::vector{false, true, true}));
}

TEST(FindSupported, OutlinesWithPartsSupportNothing) {
  map::Footprint outline = raised_block(0, 20, 0, 18);
  outline.has_parts = true;
  EXPECT_EQ(supported(std::vector{raised_block(0, 20, 9, 18), outline}, {}), (std::vector{false, true}));
}

TEST(FindSupported, FootprintsOverAWayMayFloat) {
  const std::vector passage{raised_block(0, 20, 4, 12)};
  EXPECT_EQ(supported(passage, std::vector{path_along_y(10)}), std::vector{true});
  EXPECT_EQ(supported(passage, std::vector{path_along_y(30)}), std::vector{false});
  map::Track metro = path_along_y(10);
  metro.passage = map::Passage::kTunnel;
  EXPECT_EQ(supported(passage, std::vector{metro}), std::vector{false});
}

TEST(FindSupported, ABridgeBetweenHousesIsSupportedByThem) {
  // wall to wall, and no way below
  const std::vector houses{raised_block(0, 20, 0, 15), raised_block(20, 10, 6, 9), raised_block(30, 20, 0, 15)};
  EXPECT_EQ(supported(houses, {}), (std::vector{true, true, true}));
  const std::vector hall{raised_block(0, 20, 0, 15), raised_block(20, 20, 6, 9)};
  EXPECT_EQ(supported(hall, {}), (std::vector{true, false}));
}

TEST(FindSupported, RoofsMayFloat) {
  map::Footprint roof = raised_block(0, 20, 4, 5);
  roof.building_class = static_cast<std::uint8_t>(map::BuildingClass::kRoof);
  EXPECT_EQ(supported(std::vector{roof}, {}), std::vector{true});
}

}  // namespace
}  // namespace citykiln::buildings
