#include "compiler/regions/region.h"

#include <gtest/gtest.h>

#include <set>

#include "compiler/regions/radii.h"

namespace citykiln::regions {
namespace {

// 40 cells east and 24 north, not aligned to tiles.
const RegionGrid kGrid{.extent = {{-1920, -640}, {3200, 2432}}, .tile_m = 512, .region_m = 1024, .halo_m = 300};

TEST(RegionGrid, EveryTileOfTheExtentIsInOneRegion) {
  std::multiset<scene::TileKey> tiles;
  for (const RegionKey region : regions_of(kGrid))
    for (const scene::TileKey tile : tiles_of(kGrid, region)) tiles.insert(tile);
  scene::Header header;
  header.extent = kGrid.extent, header.tile_m = kGrid.tile_m;
  const std::vector<scene::TileKey> all = scene::tiles_of(header);
  EXPECT_EQ(std::vector(tiles.begin(), tiles.end()), all);
}

TEST(RegionGrid, RegionsNearAPlaceAreThoseWhoseWidenedBoxHoldsIt) {
  const std::vector<RegionKey> keys = regions_of(kGrid);
  for (double x = -2600; x < 4000; x += 97)
    for (double y = -1300; y < 3100; y += 89) {
      std::set<RegionKey> near, expected;
      const Box2 place{{x, y}, {x, y}};
      for_each_region_near(kGrid, place, [&](std::uint32_t i) { near.insert(keys[i]); });
      for (const RegionKey key : keys)
        if (box_of(kGrid, key).widened(kGrid.halo_m).contains({x, y})) expected.insert(key);
      // more regions may be near, where the extent ends inside of a region
      EXPECT_TRUE(std::ranges::includes(near, expected)) << x << " " << y;
    }
}

TEST(RegionGrid, FarPlacesAreNearNoRegion) {
  int near = 0;
  for (const Vec2 p : {Vec2{1e7, 0}, Vec2{0, -1e7}, Vec2{-90000, 90000}})
    for_each_region_near(kGrid, {p, p}, [&](std::uint32_t) { ++near; });
  EXPECT_EQ(near, 0);
}

TEST(RegionGrid, ARegionIsAWholeMultipleOfATile) {
  EXPECT_TRUE(check_grid(kGrid));
  EXPECT_FALSE(check_grid({.extent = kGrid.extent, .tile_m = 512, .region_m = 700}));
  EXPECT_FALSE(check_grid({.extent = kGrid.extent, .tile_m = 512, .region_m = 256}));
}

}  // namespace
}  // namespace citykiln::regions
