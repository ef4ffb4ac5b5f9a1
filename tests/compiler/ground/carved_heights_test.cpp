#include "compiler/ground/carved_heights.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compiler/contract/draw.h"

namespace citykiln::ground {
namespace {

constexpr Box2 kBox{{-64, -64}, {64, 64}};

Carving road_over_hills() {
  map::Heightfield field{{-128, -128}, {32, 32}, 9, 9, {}, 0};
  for (int i = 0; i < 81; ++i) field.heights.push_back((i * 7919) % 640);
  roads::Road road;
  road.id = {{OsmType::kWay, 1}, 0};
  road.axis = {{-60, -20}, {0, 10}, {60, 0}};
  road.surface = map::SurfaceClass::kResidentialRoad;
  road.section = {{{map::LaneKind::kDriving, map::LaneWay::kBoth, 6}}, 3};
  road.profile = {{0, 4, 0}, {130, 9, 0.0625}};
  return carve(std::move(field), {std::vector{road}, {}, {}, kBox});
}

TEST(CarvedHeights, AreThoseOfTheGroundHoweverOftenTheyAreAskedFor) {
  const Carving carving = road_over_hills();
  CarvedHeights heights(carving);
  const Draw draw(1, StableId{36}, "places");
  for (std::uint32_t i = 0; i < 3000; ++i) {
    // few places, on both sides of both axes, so that most come again
    const Vec2 p{std::floor(draw.between(-16, 16, 3 * i)), std::floor(draw.between(-16, 16, 3 * i + 1)) / 1024};
    EXPECT_EQ(draw.below(2, 3 * i + 2) == 0 ? heights.at(p).heights : heights.once_at(p), heights_at(carving, p));
    EXPECT_EQ(heights.at(p).terrain_m, map::height_m_at(carving.terrain, p));
  }
}

}  // namespace
}  // namespace citykiln::ground
