#include "compiler/ground/carved_normals.h"

#include <gtest/gtest.h>

#include "compiler/contract/draw.h"

namespace citykiln::ground {
namespace {

constexpr Box2 kBox{{-64, -64}, {64, 64}};

Carving street_on_hills() {
  map::Heightfield field{{-128, -128}, {32, 32}, 9, 9, {}, 0};
  for (int i = 0; i < 81; ++i) field.heights.push_back((i * 7919) % 640);
  roads::Road road;
  road.id = {{OsmType::kWay, 1}, 0};
  road.axis = {{-60, -20}, {0, 10}, {60, 0}};
  road.surface = map::SurfaceClass::kResidentialRoad;
  road.section = {
      {{map::LaneKind::kSidewalk, map::LaneWay::kBoth, 2, 0, true}, {map::LaneKind::kDriving, map::LaneWay::kBoth, 6}},
      3};
  road.profile = {{0, 4, 0}, {130, 9, 0.0625}};
  return carve(std::move(field), {std::vector{road}, {}, {}, kBox});
}

TEST(CarvedNormals, AreThoseOfTheGroundHoweverOftenTheyAreAskedFor) {
  const Carving carving = street_on_hills();
  CarvedNormals normals(carving);
  const Draw draw(1, StableId{35}, "places");
  for (std::uint32_t i = 0; i < 3000; ++i) {
    // few places, so that most come again, on another layer or the same
    const Vec2 p{std::floor(draw.between(-16, 16, 3 * i)), std::floor(draw.between(-16, 16, 3 * i + 1))};
    const auto layer = static_cast<HeightLayer>(draw.below(4, 3 * i + 2));
    EXPECT_EQ(normals.at(grid_point(p), layer), normals_at(carving, p)[static_cast<std::size_t>(layer)]);
  }
}

}  // namespace
}  // namespace citykiln::ground
