#include "compiler/ground/cover/contained_areas.h"

#include <gtest/gtest.h>

#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/ground/cover/strip_cover.h"

namespace citykiln::ground {
namespace {

using map::LandCoverClass;

LandCoverPolygon square(std::int64_t id, LandCoverClass surface, Vec2 corner, double side_m) {
  const Vec2 far{corner.x + side_m, corner.y + side_m};
  return {.id = {{OsmType::kWay, id}, 0},
          .surface = surface,
          .area_m2 = static_cast<std::uint32_t>(side_m * side_m),
          .rings = {{corner, {far.x, corner.y}, far, {corner.x, far.y}}}};
}

// The id of the polygon on top at a place.
std::int64_t top_at(const std::vector<LandCoverPolygon>& areas, Vec2 p) {
  const LandCoverIndex index = index_land_cover(areas, {{-64, -64}, {64, 64}});
  const std::uint32_t top = land_cover_at(index, p);
  return top == kNoLandCover ? 0 : areas[top].id.osm.id;
}

TEST(ContainedAreas, OfAnyClassLieOnTopOfLargerAreasOfAnyClass) {
  for (int inner = 1; inner < static_cast<int>(LandCoverClass::kCount); ++inner)
    for (int outer = 1; outer < static_cast<int>(LandCoverClass::kCount); ++outer) {
      const auto inside = static_cast<LandCoverClass>(inner), about = static_cast<LandCoverClass>(outer);
      const std::vector<LandCoverPolygon> areas =
          with_contained_on_top({square(1, about, {0, 0}, 40), square(2, inside, {10, 10}, 16)});
      const bool is_below = about == LandCoverClass::kBuilding || is_yard(areas[1]);
      const bool was_above = map::values_of(inside).priority >= map::values_of(about).priority;
      EXPECT_EQ(top_at(areas, {18, 18}), is_below && !was_above ? 1 : 2)
          << map::values_of(inside).name << " in " << map::values_of(about).name;
      EXPECT_EQ(top_at(areas, {4, 4}), 1);
    }
}

TEST(ContainedAreas, LieOnAllAreasThatTheyLieIn) {
  const std::vector<LandCoverPolygon> areas = with_contained_on_top({square(3, LandCoverClass::kFlowerbed, {12, 12}, 5),
                                                                     square(1, LandCoverClass::kSquare, {0, 0}, 40),
                                                                     square(2, LandCoverClass::kLake, {10, 10}, 16)});
  EXPECT_EQ(top_at(areas, {14, 14}), 3);
  EXPECT_EQ(top_at(areas, {20, 20}), 2);
  EXPECT_EQ(top_at(areas, {30, 30}), 1);
}

TEST(ContainedAreas, MayShareEdgesWithWhatTheyLieIn) {
  const std::vector<LandCoverPolygon> areas = with_contained_on_top(
      {square(1, LandCoverClass::kSquare, {0, 0}, 40), square(2, LandCoverClass::kGarden, {0, 0}, 10)});
  EXPECT_EQ(top_at(areas, {5, 5}), 2);
}

TEST(ContainedAreas, MayBeginWithAnEdgeBeyondWhatTheyLieIn) {
  LandCoverPolygon garden = square(2, LandCoverClass::kGarden, {3, 10}, 60);
  // a spur of the outline, with its first edges, reaches 70 m beyond the square
  garden.rings = {{{-70, 11}, {-70, 10}, {3, 10}, {3, 3}, {397, 3}, {397, 397}, {3, 397}, {3, 11}}};
  garden.area_m2 = 155000;
  const std::vector<LandCoverPolygon> areas =
      with_contained_on_top({square(1, LandCoverClass::kSquare, {0, 0}, 410), garden});
  EXPECT_EQ(top_at(areas, {20, 20}), 2);
}

TEST(ContainedAreas, DoNotIncludeAreasThatCrossOrAreAsLarge) {
  const std::vector<LandCoverPolygon> crossing = with_contained_on_top(
      {square(1, LandCoverClass::kSquare, {0, 0}, 40), square(2, LandCoverClass::kGarden, {30, 10}, 20)});
  EXPECT_EQ(top_at(crossing, {35, 15}), 1);
  const std::vector<LandCoverPolygon> equal = with_contained_on_top(
      {square(1, LandCoverClass::kSquare, {0, 0}, 40), square(2, LandCoverClass::kGarden, {0, 0}, 40)});
  EXPECT_EQ(top_at(equal, {5, 5}), 1);
}

TEST(ContainedAreas, KeepTheirPlaceWhenTheyAreTrimmed) {
  const std::vector<LandCoverPolygon> areas = with_contained_on_top(
      {square(1, LandCoverClass::kSquare, {0, 0}, 40), square(2, LandCoverClass::kGarden, {10, 10}, 16)});
  std::vector<LandCoverPolygon> trimmed;
  for (const LandCoverPolygon& area : areas) trimmed.push_back(trimmed_to(area, {{15, 15}, {30, 30}}));
  EXPECT_EQ(top_at(trimmed, {18, 18}), 2);
}

TEST(ContainedAreas, ClearanceOnOneIsTheDistanceToWhatItLiesIn) {
  const std::vector<LandCoverPolygon> areas = with_contained_on_top(
      {square(1, LandCoverClass::kSquare, {0, 0}, 40), square(2, LandCoverClass::kGarden, {10, 10}, 16)});
  const LandCoverIndex index = index_land_cover(areas, {{-64, -64}, {64, 64}});
  const int paved = map::values_of(LandCoverClass::kSquare).priority;
  EXPECT_DOUBLE_EQ(clearance_m(index, {18, 18}, paved, 30), 8);
  EXPECT_DOUBLE_EQ(clearance_m(index, {12, 18}, paved, 30), 2);
  EXPECT_DOUBLE_EQ(clearance_m(index, {5, 5}, paved, 30), 0);
}

}  // namespace
}  // namespace citykiln::ground
