#include "compiler/ground/grading/graded_terrain.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compiler/contract/random_sequence.h"
#include "compiler/ground/plan.h"
#include "tests/compiler/roads/made_road.h"

namespace citykiln::ground {
namespace {

constexpr Box2 kWest{{0, 0}, {128, 128}}, kEast{{128, 0}, {256, 128}};

map::Heightfield finely_sampled_level(double z_m) {
  map::Heightfield field{{-256, -256}, {64, 64}, 13, 13, {}, 0};
  field.heights.assign(13 * 13, static_cast<std::int32_t>(z_m / map::kHeightQuantum_m));
  return field;
}

// Waters of many levels, and a street with a wider junction, some metres apart on either side of x = 128.
struct WatersAndStreet {
  std::vector<roads::Road> roads;
  std::vector<LandCoverPolygon> surfaces;
};

WatersAndStreet waters_and_street() {
  WatersAndStreet made{{roads::made_road(1, {{0, 64}, {256, 64}}, 6)}, {}};
  made.roads[0].profile = {{0, 12, 0}, {256, 14, 0}};
  for (int i = 0; i < 12; ++i) {
    const double x = 106 + 4 * i, y = i < 6 ? 4 + 8 * i : 32 + 8 * i;
    LandCoverPolygon pond{{{OsmType::kWay, i + 2}, 0}, map::LandCoverClass::kLake, 8, {}};
    pond.rings = {{{x, y}, {x + 2, y}, {x + 2, y + 4}, {x, y + 4}}}, pond.level_m = 10 + i % 5;
    made.surfaces.push_back(pond);
    LandCoverPolygon corner{{{OsmType::kNode, i + 2}, 0}, map::LandCoverClass::kResidentialRoad, kJunctionArea_m2, {}};
    corner.rings = {{{x, 60}, {x + 2, 60}, {x + 2, 72}, {x, 72}}}, corner.is_graded = true;
    if (i % 2 == 0) made.surfaces.push_back(corner);
  }
  return made;
}

TEST(GradedTerrain, TilesAgreeAllOverWhatBothMayBeAskedFor) {
  const WatersAndStreet both = waters_and_street();
  const auto graded = [&](const Box2& tile) {
    return grade_terrain(finely_sampled_level(16), {both.roads, {}, both.surfaces, tile.widened(kGrading_m)});
  };
  const GradedTerrain west = graded(kWest), east = graded(kEast);
  const RandomSequence draw(1, StableId{1}, "places");
  int under_water = 0, on_roads = 0;
  for (std::uint32_t i = 0; i < 20000; i += 2) {
    const Vec2 p{draw.between(128 - kGrading_m, 128 + kGrading_m, i), draw.between(0, 128, i + 1)};
    const Heights heights = heights_at(west, p);
    EXPECT_EQ(heights, heights_at(east, p)) << p.x << " " << p.y;
    under_water += layer_height_m(heights, HeightLayer::kWater) != layer_height_m(heights, HeightLayer::kLand);
    on_roads += layer_height_m(heights, HeightLayer::kRoad) != layer_height_m(heights, HeightLayer::kLand);
  }
  EXPECT_GT(under_water, 1000);
  EXPECT_GT(on_roads, 1000);
}

}  // namespace
}  // namespace citykiln::ground
