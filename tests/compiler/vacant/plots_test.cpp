#include "compiler/vacant/plots.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/map/buildings/building_classes.h"

namespace citykiln::vacant {
namespace {

using lots::LotKind;
using map::LandCoverClass;

Ring made_box(Vec2 low, Vec2 high) { return {low, {high.x, low.y}, high, {low.x, high.y}}; }

ground::LandCoverPolygon made_area(std::int64_t id, LandCoverClass surface, Vec2 low, Vec2 high) {
  const Ring ring = made_box(low, high);
  const auto area = static_cast<std::uint32_t>((high.x - low.x) * (high.y - low.y));
  return {{{OsmType::kWay, id}, 0}, surface, area, {ring}};
}

const Box2 kTile{{-200, -200}, {200, 200}};

// The tile with a street along y = 0, 6 m wide.
struct MadeLand {
  std::vector<ground::LandCoverPolygon> areas;
  std::vector<roads::Road> roads{1};
  std::vector<buildings::Building> buildings{};

  MadeLand() {
    roads[0].id = {{OsmType::kWay, 1000}, 0};
    roads[0].axis = {{-190, 0}, {190, 0}};
    roads[0].surface = LandCoverClass::kResidentialRoad;
    roads[0].section.lanes = {{map::LaneKind::kDriving, map::LaneDirection::kBackward, 3},
                              {map::LaneKind::kDriving, map::LaneDirection::kForward, 3}};
    roads[0].section.axis_offset_m = 3;
  }

  Plots plots(std::uint64_t seed = 1) const {
    std::vector<ground::LandCoverPolygon> cover = areas;
    cover.push_back(made_area(1000, LandCoverClass::kResidentialRoad, {-190, -3}, {190, 3}));
    for (const buildings::Building& building : buildings)
      cover.push_back({building.id, LandCoverClass::kBuilding, 1, {building.footprint.outer}});
    const ground::LandCoverIndex index = ground::index_land_cover(cover, kTile.widened(48));
    return plots_of({areas, roads, buildings, index, kTile, seed});
  }

  void add_building(std::int64_t id, map::BuildingClass own, Vec2 low, Vec2 high) {
    buildings::Building building;
    building.id = {{OsmType::kWay, id}, 0}, building.footprint = {made_box(low, high), {}};
    building.building_class = static_cast<std::uint8_t>(own);
    buildings.push_back(building);
  }
};

std::ptrdiff_t count_of(const Plots& plots, LotKind kind) {
  return std::ranges::count(plots.grounds, kind, &lots::Yard::kind);
}

TEST(Plots, IndustryHasYardsAlongItsStreets) {
  MadeLand land;
  land.areas = {made_area(1, LandCoverClass::kIndustrial, {-195, -150}, {195, 150})};
  const Plots plots = land.plots();
  EXPECT_GT(count_of(plots, LotKind::kStorage), 8);
  EXPECT_EQ(plots.grounds.size(), 30u) << "15 on each side";
  for (const lots::Yard& ground : plots.grounds)
    for (const Vec2 p : ground.polygon.outer) EXPECT_GE(std::abs(p.y), 2.5) << "beside the street";
}

TEST(Plots, SurfacesLieAboveTheLandUseAndBelowYards) {
  MadeLand land;
  land.areas = {made_area(1, LandCoverClass::kIndustrial, {-195, -150}, {195, 150})};
  const auto lawn = made_area(2, LandCoverClass::kLawn, {0, 3}, {20, 20});
  const Plots plots = land.plots();
  ASSERT_FALSE(plots.surfaces.empty());
  for (const ground::LandCoverPolygon& surface : plots.surfaces) {
    EXPECT_TRUE(ground::covers(surface, land.areas[0]));
    EXPECT_TRUE(ground::covers(lawn, surface));
  }
}

// Land use inside of a park covers the park, and the plot covers both.
TEST(Plots, SurfacesLieAboveLandUseThatIsRaised) {
  MadeLand land;
  land.areas = {made_area(1, LandCoverClass::kIndustrial, {-195, -150}, {195, 150})};
  land.areas[0].raised_priority = 28;
  const Plots plots = land.plots();
  ASSERT_FALSE(plots.surfaces.empty());
  for (const ground::LandCoverPolygon& surface : plots.surfaces) EXPECT_TRUE(ground::covers(surface, land.areas[0]));
}

TEST(Plots, FinerGroundAndLotsHaveNone) {
  for (const LandCoverClass finer : {LandCoverClass::kPark, LandCoverClass::kLawn, LandCoverClass::kParking}) {
    MadeLand land;
    land.areas = {made_area(1, LandCoverClass::kIndustrial, {-195, -150}, {195, 150}),
                  made_area(2, finer, {-194, -149}, {194, 149})};
    EXPECT_TRUE(land.plots().grounds.empty());
  }
}

TEST(Plots, AreLeftOverForTheMostPart) {
  MadeLand land;
  // meadow covers the half of each plot that is farther from the street
  land.areas = {made_area(1, LandCoverClass::kIndustrial, {-195, -150}, {195, 150}),
                made_area(2, LandCoverClass::kMeadow, {-194, 13}, {194, 149}),
                made_area(3, LandCoverClass::kMeadow, {-194, -149}, {194, -21})};
  const Plots plots = land.plots();
  EXPECT_EQ(plots.grounds.size(), 15u) << "on the side where a quarter is covered";
  for (const lots::Yard& ground : plots.grounds) EXPECT_LT(ground.polygon.outer[0].y, 0);
}

TEST(Plots, UnmappedLandIsATownsNearBuildingsAlone) {
  MadeLand land;
  EXPECT_TRUE(land.plots().grounds.empty());
  land.add_building(5, map::BuildingClass::kHouse, {0, 30}, {10, 40});
  const Plots plots = land.plots();
  EXPECT_FALSE(plots.grounds.empty());
  EXPECT_LT(plots.grounds.size(), 8u);
}

TEST(Plots, GreenAboutAPlotMakesItGreen) {
  std::ptrdiff_t green_about = 0, paved_about = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed)
    for (const LandCoverClass about : {LandCoverClass::kGrass, LandCoverClass::kParking}) {
      MadeLand land;
      land.areas = {made_area(1, LandCoverClass::kResidential, {-195, -150}, {195, 150}),
                    made_area(2, about, {-194, 20}, {194, 60}), made_area(3, about, {-194, -60}, {194, -20})};
      (about == LandCoverClass::kGrass ? green_about : paved_about) += count_of(land.plots(seed), LotKind::kGreen);
    }
  EXPECT_EQ(green_about, 600);
  EXPECT_LT(paved_about, 400);
}

TEST(Plots, LieWhollyInTheirTile) {
  MadeLand land;
  land.roads[0].axis = {{-240, 0}, {240, 0}};
  land.areas = {made_area(1, LandCoverClass::kIndustrial, {-245, -150}, {245, 150})};
  for (const ground::LandCoverPolygon& surface : land.plots().surfaces)
    for (const Ring& ring : surface.rings)
      for (const Vec2 p : ring) EXPECT_LE(std::abs(p.x), 199);
}

TEST(Plots, SchoolsHaveAPlaygroundInTheirOwnLand) {
  MadeLand land;
  land.areas = {made_area(1, LandCoverClass::kResidential, {-195, -150}, {195, 150}),
                made_area(2, LandCoverClass::kInstitution, {-100, 20}, {0, 120})};
  land.add_building(5, map::BuildingClass::kSchool, {-60, 30}, {-20, 45});
  const Plots plots = land.plots();
  ASSERT_EQ(count_of(plots, LotKind::kSchool), 1);
  const auto school = std::ranges::find(plots.grounds, LotKind::kSchool, &lots::Yard::kind);
  EXPECT_GT(area_m2(school->polygon), 500);
  for (const ground::LandCoverPolygon& surface : plots.surfaces) {
    if (surface.id.osm.id != 2) continue;
    EXPECT_TRUE(ground::covers(surface, land.areas[1]));
    for (const Vec2 p : surface.rings.front()) EXPECT_TRUE((Box2{{-100.1, 19.9}, {0.1, 120.1}}.contains(p)));
  }
}

TEST(Plots, AllotmentsHaveRowsOfPlots) {
  MadeLand land;
  land.areas = {made_area(1, LandCoverClass::kAllotments, {-100, 20}, {0, 120})};
  const Plots plots = land.plots();
  EXPECT_GT(count_of(plots, LotKind::kAllotment), 20);
  for (const lots::Yard& ground : plots.grounds) {
    EXPECT_NEAR(area_m2(ground.polygon), 11 * 18, 0.1);
    for (const Vec2 p : ground.polygon.outer) EXPECT_TRUE((Box2{{-100, 20}, {0, 120}}.widened(0.01).contains(p)));
  }
}

// At the borders of the tile paths would end in neighbours that do not know them.
TEST(Plots, SurfacesOfAllotmentsLieInTheTile) {
  MadeLand land;
  for (double shift_m = 0; shift_m < 3; shift_m += 0.25) {
    land.areas = {made_area(1, LandCoverClass::kAllotments, kTile.min - Vec2{shift_m, shift_m}, kTile.max)};
    for (const ground::LandCoverPolygon& surface : land.plots().surfaces)
      for (const Vec2 p : surface.rings.front()) EXPECT_TRUE(kTile.contains(p)) << shift_m;
  }
}

TEST(Plots, BuildingSitesAreGroundsAsMapped) {
  MadeLand land;
  land.areas = {made_area(1, LandCoverClass::kConstruction, {-100, 20}, {0, 120})};
  const Plots plots = land.plots();
  ASSERT_EQ(plots.grounds.size(), 1u);
  EXPECT_EQ(plots.grounds[0].polygon.outer, land.areas[0].rings.front());
  EXPECT_TRUE(plots.surfaces.empty());
}

}  // namespace
}  // namespace citykiln::vacant
