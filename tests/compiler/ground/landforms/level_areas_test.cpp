#include "compiler/ground/landforms/level_areas.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compiler/ground/landforms/landform_index.h"
#include "tests/compiler/ground/profiles/made_network.h"

namespace citykiln::ground {
namespace {

using map::LandCoverClass;

map::AreaFeature made_area(std::int64_t id, LandCoverClass surface, const Box2& box) {
  map::AreaFeature area;
  area.id = {{OsmType::kWay, id}, 0}, area.surface = surface;
  area.polygon.outer = {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
  area.area_m2 = area_m2(area.polygon);
  return area;
}

map::Heightfield hillside(double grade) {
  return field_from([&](double x, double y) { return 300 + grade * x + 0.5 * std::sin(y / 5); }, 512, 16);
}

double land_at(const LandformIndex& index, const map::Heightfield& field, Vec2 p) {
  return with_landforms_m(index, p, map::height_m_at(field, p));
}

TEST(LevelAreas, APitchIsAPlaneOfOnePercentOnAHillside) {
  const map::Heightfield field = hillside(0.1);
  const std::vector<map::AreaFeature> areas{made_area(1, LandCoverClass::kPitch, {{0, 0}, {100, 64}})};
  const LandformIndex index = index_landforms(level_areas(areas, field));
  const double corner_m = land_at(index, field, {0, 0});
  EXPECT_NEAR(land_at(index, field, {50, 32}), 305, 0.5);
  for (double x = 0; x <= 100; x += 10)
    for (double y = 0; y <= 64; y += 8) EXPECT_NEAR(land_at(index, field, {x, y}), corner_m + x * 0.01, 0.08);
}

TEST(LevelAreas, AreNotMadeWhereTheTerrainIsLevelAlready) {
  const map::Heightfield field = field_from([](double, double) { return 300; }, 512, 16);
  EXPECT_TRUE(level_areas(std::vector{made_area(1, LandCoverClass::kPitch, {{0, 0}, {100, 64}})}, field).empty());
}

TEST(LevelAreas, MeetTheLandWithoutACliff) {
  const map::Heightfield field = hillside(0.1);
  const std::vector<map::AreaFeature> areas{made_area(1, LandCoverClass::kPitch, {{0, 0}, {100, 64}})};
  const LandformIndex index = index_landforms(level_areas(areas, field));
  for (double x = -40; x < 140; x += 1)
    for (double y = -40; y < 104; y += 4)
      EXPECT_LT(std::abs(land_at(index, field, {x + 1, y}) - land_at(index, field, {x, y})), 0.6) << x << " " << y;
  for (const Vec2 p : {Vec2{-33, 30}, Vec2{133, 30}, Vec2{50, 97}})
    EXPECT_EQ(land_at(index, field, p), map::height_m_at(field, p));
}

TEST(LevelAreas, APitchAndTheTrackAboutItHaveOnePlane) {
  const map::Heightfield field = hillside(0.1);
  const std::vector<map::AreaFeature> areas{made_area(1, LandCoverClass::kRunningTrack, {{-10, -10}, {110, 74}}),
                                            made_area(2, LandCoverClass::kPitch, {{0, 0}, {100, 64}})};
  const std::vector<Landform> forms = level_areas(areas, field);
  ASSERT_EQ(forms.size(), 2u);
  EXPECT_EQ(forms[0].profile[0].tilt, forms[1].profile[0].tilt);
  const LandformIndex index = index_landforms(forms);
  EXPECT_NEAR(land_at(index, field, {-5, 32}) + 0.0625, land_at(index, field, {1, 32}), 0.03);
}

TEST(LevelAreas, SmallCarParksFollowTheLand) {
  const std::vector<map::AreaFeature> areas{made_area(1, LandCoverClass::kParking, {{0, 0}, {20, 20}}),
                                            made_area(2, LandCoverClass::kGrass, {{0, 0}, {200, 200}})};
  EXPECT_TRUE(level_areas(areas, hillside(0.1)).empty());
}

}  // namespace
}  // namespace citykiln::ground
