#include "compiler/invent/land/make_terrain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "compiler/geometry/segment.h"
#include "compiler/invent/land/drainage.h"
#include "compiler/invent/land/erode.h"
#include "compiler/invent/land/fill_pits.h"

namespace citykiln::invent {
namespace {

TerrainSettings small_land() {
  TerrainSettings settings;
  settings.fractal = {.power = 6, .initial_height_m = 200, .spread_m = 60, .reduction = 0.55};
  settings.river_from_km2 = 0.1;
  return settings;
}

Lattice lattice_of(const DiamondSquare& fractal, std::uint64_t seed) {
  return {1 << fractal.power, 10, diamond_square(fractal, seed)};
}

/// Points inside the border without a lower neighbour, lakes left out.
int pits_of(const Terrain& terrain) {
  int pits = 0;
  const int count = terrain.cells + 1;
  const auto height = [&](int x, int y) { return terrain.heights_m[static_cast<std::size_t>(y) * count + x]; };
  for (int y = 1; y < terrain.cells; ++y)
    for (int x = 1; x < terrain.cells; ++x) {
      bool drains = false;
      for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) drains |= height(x + i, y + j) < height(x, y);
      // the lattice's step about a lake belongs to its shore
      const bool is_lake = std::ranges::any_of(terrain.lakes, [&](const Polygon& lake) {
        return contains(lake, terrain.point(x, y)) ||
               distance_to_ring(lake.outer, terrain.point(x, y)) < terrain.step_m() * 3;
      });
      pits += drains || is_lake ? 0 : 1;
    }
  return pits;
}

TEST(FillPits, EveryPointInsideDrainsAndNoneIsLowered) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Lattice before = lattice_of({.power = 6, .initial_height_m = 0, .spread_m = 50, .reduction = 0.7}, seed);
    Lattice after = before;
    fill_pits(after);
    double raised = 0;
    for (std::size_t i = 0; i < after.size(); ++i) {
      EXPECT_GE(after.heights_m[i], before.heights_m[i]);
      raised = std::max(raised, after.heights_m[i] - before.heights_m[i]);
      bool drains = after.is_on_border(i);
      after.for_each_neighbour(i, [&](std::size_t j, double) { drains |= after.heights_m[j] < after.heights_m[i]; });
      EXPECT_TRUE(drains) << "point " << i;
    }
    EXPECT_GT(raised, 0) << "the fractal had no pit to fill";
  }
}

TEST(Drainage, AllLandReachesTheBorder) {
  Lattice lattice = lattice_of({.power = 6, .initial_height_m = 0, .spread_m = 50, .reduction = 0.6}, 4);
  fill_pits(lattice);
  const Drainage drainage = drain(lattice);
  double out_m2 = 0;
  for (std::size_t i = 0; i < lattice.size(); ++i)
    if (drainage.receiver[i] == i) {
      out_m2 += drainage.area_m2[i];
      EXPECT_TRUE(lattice.is_on_border(i));
    }
  EXPECT_NEAR(out_m2, lattice.size() * 100.0, 1e-6);
}

TEST(Erode, LowersAValleyTowardsItsOutlet) {
  Lattice lattice = lattice_of({.power = 6, .initial_height_m = 0, .spread_m = 50, .reduction = 0.6}, 4);
  fill_pits(lattice);
  const Lattice before = lattice;
  erode(lattice, {.steps = 10, .strength = 0.02, .creep = 0}, {});
  const Drainage drainage = drain(before);
  double lowered = 0;
  for (std::size_t i = 0; i < lattice.size(); ++i) {
    if (lattice.is_on_border(i)) {
      EXPECT_EQ(lattice.heights_m[i], before.heights_m[i]);
    }
    if (drainage.area_m2[i] > 1e5) lowered = std::max(lowered, before.heights_m[i] - lattice.heights_m[i]);
  }
  EXPECT_GT(lowered, 1);
}

TEST(MakeTerrain, HasNoPits) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    TerrainSettings settings = small_land();
    settings.has_coast = seed % 3 == 0;
    settings.lakes = seed % 2 == 0 ? 2 : 0;
    EXPECT_EQ(pits_of(make_terrain(settings, 512, seed)), 0) << "seed " << seed;
  }
}

TEST(MakeTerrain, RiversRunDownhillAndEndInWaterOrOnTheBorder) {
  int rivers = 0, rises = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    TerrainSettings settings = small_land();
    settings.has_coast = seed % 3 == 0;
    settings.lakes = seed % 2 == 0 ? 2 : 0;
    const Terrain terrain = make_terrain(settings, 512, seed);
    for (const River& river : terrain.rivers) {
      ++rivers;
      ASSERT_EQ(river.axis.size(), river.width_m.size());
      // a river out of a lake begins on its bed
      const bool is_outlet = std::ranges::any_of(terrain.lakes, [&](const Polygon& lake) {
        const Vec2 from = river.axis.front();
        return contains(lake, from) || distance_to_ring(lake.outer, from) < terrain.step_m() * 1.5;
      });
      rises += !is_outlet && terrain.height_m(river.axis.back()) > terrain.height_m(river.axis.front()) + 1e-3;
      const Vec2 end = river.axis.back();
      const bool is_on_border = std::max(std::abs(end.x), std::abs(end.y)) > terrain.side_m / 2 - 1e-6;
      const bool is_confluence = std::ranges::any_of(
          terrain.rivers, [&](const River& other) { return &other != &river && other.axis.front() == end; });
      const bool is_in_water =
          terrain.height_m(end) < terrain.sea_level_m || std::ranges::any_of(terrain.lakes, [&](const Polygon& lake) {
            return contains(lake, end) || distance_to_ring(lake.outer, end) < terrain.step_m() * 1.5;
          });
      EXPECT_TRUE(is_on_border || is_confluence || is_in_water) << "seed " << seed << " at " << end.x << " " << end.y;
    }
  }
  EXPECT_GT(rivers, 40);
  // a river nearby may have lowered the ground of the first point
  EXPECT_LE(rises, 1);
}

TEST(MakeTerrain, GroundUnderARiverFallsWithin20CentimetresAtEachPoint) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Terrain terrain = make_terrain(small_land(), 512, seed);
    for (const River& river : terrain.rivers) {
      double lowest_m = 1e9;
      for (const Vec2 p : river.axis) {
        EXPECT_LE(terrain.height_m(p), lowest_m + 0.2) << "seed " << seed;
        lowest_m = std::min(lowest_m, terrain.height_m(p));
      }
    }
  }
}

TEST(MakeTerrain, LakesAreBelowTheirShores) {
  int lakes = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    TerrainSettings settings = small_land();
    settings.lakes = 2;
    settings.fractal.reduction = 0.65;
    const Terrain terrain = make_terrain(settings, 640, seed);
    ASSERT_EQ(terrain.lakes.size(), terrain.lake_levels_m.size());
    for (std::size_t i = 0; i < terrain.lakes.size(); ++i) {
      ++lakes;
      for (const Vec2 p : terrain.lakes[i].outer) EXPECT_NEAR(terrain.height_m(p), terrain.lake_levels_m[i], 6);
      EXPECT_GT(area_m2(terrain.lakes[i]), 1000);
    }
  }
  EXPECT_GT(lakes, 5);
}

TEST(MakeTerrain, ACoastHasSeaAndLandOnTheMap) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    TerrainSettings settings = small_land();
    settings.has_coast = true;
    const Terrain terrain = make_terrain(settings, 512, seed);
    int wet = 0, all = 0;
    for (double x = -250; x <= 250; x += 20)
      for (double y = -250; y <= 250; y += 20) ++all, wet += terrain.is_water({x, y}) ? 1 : 0;
    EXPECT_GT(wet, 0) << "seed " << seed;
    EXPECT_LT(wet, all) << "seed " << seed;
  }
}

TEST(MakeTerrain, TheIndexOfWaterAgreesWithAllWater) {
  TerrainSettings settings = small_land();
  settings.lakes = 2;
  Terrain terrain = make_terrain(settings, 512, 6);
  Terrain slow = terrain;
  slow.water_index = nullptr;
  int wet = 0;
  for (double x = -300; x <= 300; x += 3.7)
    for (double y = -300; y <= 300; y += 3.7) {
      ASSERT_EQ(terrain.is_water({x, y}), slow.is_water({x, y})) << x << " " << y;
      wet += terrain.is_water({x, y}) ? 1 : 0;
    }
  EXPECT_GT(wet, 0);
}

TEST(MakeTerrain, TheSameSeedGivesTheSameHeights) {
  const Terrain a = make_terrain(small_land(), 512, 5), b = make_terrain(small_land(), 512, 5);
  EXPECT_EQ(a.heights_m, b.heights_m);
  EXPECT_NE(a.heights_m, make_terrain(small_land(), 512, 6).heights_m);
}

}  // namespace
}  // namespace citykiln::invent
