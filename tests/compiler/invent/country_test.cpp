#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "compiler/geometry/segment.h"
#include "compiler/invent/country/add_country.h"
#include "compiler/invent/country/split_convex.h"
#include "compiler/invent/country/taken_land.h"
#include "compiler/invent/land/contour.h"
#include "compiler/invent/land/make_terrain.h"
#include "compiler/invent/land/noise.h"

namespace citykiln::invent {
namespace {

constexpr double kSide_m = 768;

Terrain land(std::uint64_t seed) { return make_terrain({.river_from_km2 = 0.2}, kSide_m, seed); }

InventedMap village() {
  InventedMap map;
  map.lines.push_back({{{-384, 20}, {-100, 0}, {120, 30}, {384, -60}}, {{"highway", "tertiary"}}});
  map.lines.push_back({{{-100, 0}, {-80, 200}, {0, 384}}, {{"highway", "residential"}}});
  map.areas.push_back({{{{-160, -70}, {160, -70}, {160, 90}, {-160, 90}}, {}}, {{"landuse", "residential"}}});
  return map;
}

bool is_field(const InventedArea& area) {
  const std::string_view use = value_in(area.tags, "landuse");
  return use == "farmland" || use == "meadow" || use == "orchard";
}

TEST(SplitConvex, PartsAndGapAddUp) {
  const Ring ring = {{0, 0}, {10, 0}, {10, 6}, {0, 6}};
  const SplitConvex split = split_convex(ring, {4, 0}, {0, 1}, 0.5);
  EXPECT_DOUBLE_EQ(signed_area_m2(split.left), 3.5 * 6);
  EXPECT_DOUBLE_EQ(signed_area_m2(split.right), 5.5 * 6);
  EXPECT_EQ(distance(split.from, split.to), 6);
}

TEST(Contour, RingsAreClosedAndTheirAreaIsThatAboveZero) {
  const ValueGrid grid = value_grid(400, 10, [](Vec2 p) { return 120 - length(p); });
  const std::vector<Polygon> round = area_above_zero(grid, 0);
  ASSERT_EQ(round.size(), 1U);
  EXPECT_NEAR(area_m2(round[0]), 3.14159 * 120 * 120, 300);
  const ValueGrid annulus = value_grid(400, 10, [](Vec2 p) { return 40 - std::abs(length(p) - 100); });
  const std::vector<Polygon> with_hole = area_above_zero(annulus, 0);
  ASSERT_EQ(with_hole.size(), 1U);
  ASSERT_EQ(with_hole[0].holes.size(), 1U);
  EXPECT_LT(signed_area_m2(with_hole[0].holes[0]), 0);
  EXPECT_NEAR(area_m2(with_hole[0]), 3.14159 * (140 * 140 - 60 * 60), 600);
}

TEST(Contour, AnAreaOverTheWholeGridIsClosedAlongItsBorder) {
  const std::vector<Polygon> all = area_above_zero(value_grid(100, 10, [](Vec2) { return 1; }), 0);
  ASSERT_EQ(all.size(), 1U);
  EXPECT_NEAR(area_m2(all[0]), 100 * 100, 60);
}

TEST(AddCountry, FieldsOverlapNeitherEachOtherNorTownsRoadsAndWoods) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Terrain terrain = land(seed);
    InventedMap map = village();
    add_country(terrain, {}, kSide_m, seed, map);
    std::vector<const InventedArea*> fields, others;
    for (const InventedArea& area : map.areas) (is_field(area) ? fields : others).push_back(&area);
    EXPECT_GT(fields.size(), 8U) << "seed " << seed;
    int covered = 0;
    for (double x = -380; x < 380; x += 6.3)
      for (double y = -380; y < 380; y += 6.7) {
        const Vec2 p{x, y};
        const auto holds = [&](const InventedArea* area) { return contains(area->polygon, p); };
        const auto in_fields = std::ranges::count_if(fields, holds);
        covered += in_fields > 0 ? 1 : 0;
        ASSERT_LE(in_fields, 1) << seed << ": " << x << " " << y;
        if (in_fields == 0) continue;
        EXPECT_FALSE(std::ranges::any_of(others, holds)) << seed << ": " << x << " " << y;
        for (const InventedLine& line : map.lines)
          if (half_right_of_way_m(line) > 0) {
            EXPECT_GE(distance_to_polyline(line.axis, p), half_right_of_way_m(line) * 0.9)
                << seed << ": " << x << " " << y;
          }
      }
    EXPECT_GT(covered, 3000) << "little land has fields, seed " << seed;
  }
}

TEST(AddCountry, TracksMeetRoadsInEqualPoints) {
  const Terrain terrain = land(2);
  InventedMap map = village();
  const std::size_t roads = map.lines.size();
  add_country(terrain, {.tracks_per_km2 = 8}, kSide_m, 2, map);
  std::map<Vec2, int> uses;
  for (const InventedLine& line : map.lines)
    for (const Vec2 p : line.axis) ++uses[p];
  int tracks = 0, meets = 0;
  for (std::size_t i = roads; i < map.lines.size(); ++i) {
    const std::string_view road = value_in(map.lines[i].tags, "highway");
    if (road != "track" && road != "path") continue;
    ++tracks;
    for (const Vec2 p : {map.lines[i].axis.front(), map.lines[i].axis.back()}) meets += uses[p] > 1 ? 1 : 0;
  }
  EXPECT_GT(tracks, 0);
  EXPECT_GE(meets, tracks);
}

TEST(AddCountry, MoreWoodIsAskedForMoreIsThere) {
  const auto wood_m2 = [](double share) {
    InventedMap map;
    add_country(land(3), {.wood_share = share, .has_farm_fields = false}, kSide_m, 3, map);
    double sum = 0;
    for (const InventedArea& area : map.areas)
      if (value_in(area.tags, "natural") == "wood") sum += area_m2(area.polygon);
    return sum / (kSide_m * kSide_m);
  };
  EXPECT_LT(wood_m2(0.1), wood_m2(0.6));
  EXPECT_GT(wood_m2(0.6), 0.4);
}

TEST(AddCountry, AFunctionOfTheSeed) {
  const auto sizes = [](std::uint64_t seed) {
    InventedMap map = village();
    add_country(land(1), {}, kSide_m, seed, map);
    std::vector<Polygon> polygons;
    for (const InventedArea& area : map.areas) polygons.push_back(area.polygon);
    return polygons;
  };
  EXPECT_EQ(sizes(1), sizes(1));
  EXPECT_NE(sizes(1), sizes(2));
}

}  // namespace
}  // namespace citykiln::invent
