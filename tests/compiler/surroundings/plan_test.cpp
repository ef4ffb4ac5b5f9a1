#include "compiler/surroundings/plan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include "compiler/contract/findings/report.h"
#include "compiler/map/plane/lonlat_box.h"
#include "compiler/source/read_raster.h"
#include "compiler/surroundings/curvature.h"
#include "compiler/surroundings/grid_lines.h"
#include "tests/test_files.h"

namespace citykiln::surroundings {
namespace {

const LonLat kOrigin{1.52, 42.51};
const Place kPlace{.extent = {{-1664, -1664}, {2048, 896}}, .tile_m = 1024};

// A raster in degrees that reaches some 80 km to all sides, or less.
template <typename Height>
source::Raster raster_of(Height height_m, double west_deg = 0.7, double east_deg = 2.4) {
  constexpr double kSpacing_deg = 1.0 / 240, kNorth = 43.3, kSouth = 41.7;
  source::Raster raster;
  raster.file_name = "hills.hgt";
  raster.columns = static_cast<int>((east_deg - west_deg) / kSpacing_deg) + 1;
  raster.rows = static_cast<int>((kNorth - kSouth) / kSpacing_deg) + 1;
  raster.from_grid = {west_deg, kSpacing_deg, 0, kNorth, 0, -kSpacing_deg};
  raster.spacing_m = {340, 460};
  for (int r = 0; r < raster.rows; ++r)
    for (int c = 0; c < raster.columns; ++c)
      raster.heights_m.push_back(static_cast<float>(height_m(west_deg + kSpacing_deg * c, kNorth - kSpacing_deg * r)));
  return raster;
}

double hills_m(double lon_deg, double lat_deg) {
  return 1500 + 800 * std::sin(lon_deg * 40) * std::cos(lat_deg * 55) + 150 * std::sin(lon_deg * 300);
}

Surroundings planned(const std::vector<source::Raster>& rasters, const Place& place = kPlace) {
  const auto around = plan(rasters, map::Plane(kOrigin), place);
  EXPECT_TRUE(around);
  return *around;
}

TEST(GridLines, GrowWithTheDistanceAndHoldAllBordersOfTiles) {
  const std::vector<std::int32_t> lines = lines_for(-1664, 2048, 1024);
  EXPECT_EQ(lines.front(), -1664 - kReach_m);
  EXPECT_EQ(lines.back(), 2048 + kReach_m);
  for (const int border : {-1664, -1024, 0, 1024, 2048}) EXPECT_TRUE(std::ranges::binary_search(lines, border));
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const double step_m = lines[i] - lines[i - 1], away_m = std::max({lines[i] - 2048.0, -1664.0 - lines[i - 1], 0.0});
    EXPECT_GT(step_m, 0);
    EXPECT_LE(step_m, std::max<double>(128, away_m * kCellShare)) << lines[i];
  }
  EXPECT_LT(lines.size(), 300);
}

TEST(Curvature, LowersLandByTheSquareOfItsDistanceLessRefraction) {
  EXPECT_EQ(drop_m(0), 0);
  // tables of surveyors: 0.0683 m at 1 km for k = 0.13
  EXPECT_NEAR(drop_m(1000), 0.0683, 0.0001);
  EXPECT_NEAR(drop_m(60000), 246, 1);
}

TEST(PlanSurroundings, StatesTheLargestErrorAgainstAllSamplesBeyondTheExtent) {
  const std::vector<source::Raster> rasters = {raster_of(hills_m)};
  const Surroundings around = planned(rasters);
  ASSERT_FALSE(around.is_empty());
  EXPECT_TRUE(is_sound(around));
  const map::Plane plane(kOrigin);
  double largest_m = 0, sum_m2 = 0;
  int count = 0;
  for (int r = 0; r < rasters[0].rows; ++r)
    for (int c = 0; c < rasters[0].columns; ++c) {
      const auto& g = rasters[0].from_grid;
      const Vec2 p = plane.forward({g[0] + g[1] * c, g[3] + g[5] * r});
      if (!around.box().contains(p) || kPlace.extent.contains(p)) continue;
      const double error_m = std::abs(height_m_at(around, p) - rasters[0].at(c, r));
      largest_m = std::max(largest_m, error_m), sum_m2 += error_m * error_m, ++count;
    }
  ASSERT_GT(count, 50000);
  EXPECT_GE(around.error_m, largest_m);
  EXPECT_LE(around.error_m, largest_m + 1);
  EXPECT_NEAR(around.rms_error_m, std::sqrt(sum_m2 / count), 1);
  EXPECT_GT(around.rms_error_m, 1);
}

TEST(PlanSurroundings, BesideTheExtentHeightsAreThoseOfTheHeightmap) {
  const Surroundings around = planned({raster_of([](double lon_deg, double) { return 900 + 1000 * (lon_deg - 1); })});
  const map::Plane plane(kOrigin);
  for (const double along_m : {-1600.0, 0.0, 1300.0})
    for (const double away_m : {0.0, 30.0, 200.0}) {
      const Vec2 p{2048 + away_m, std::min(along_m, 800.0)};
      EXPECT_NEAR(height_m_at(around, p), 900 + 1000 * (plane.backward(p).lon_deg - 1), 1) << p.x << " " << p.y;
    }
}

TEST(PlanSurroundings, WithoutHeightmapsTheLandGoesOnAtTheHeightsOfTheExtent) {
  const Surroundings level = planned({});
  ASSERT_FALSE(level.is_empty());
  EXPECT_TRUE(is_sound(level));
  EXPECT_EQ(std::ranges::count(level.heights_m, 0), std::ssize(level.heights_m));
  const map::Heightfield heights{
      .min = {-2048, -2048}, .step_m = {4096, 4096}, .columns = 2, .rows = 2, .heights = {6400, 6400, 6400, 6400}};
  Place place = kPlace;
  place.heights = &heights;
  const Surroundings high = planned({}, place);
  EXPECT_EQ(std::ranges::count(high.heights_m, 100), std::ssize(high.heights_m));
}

TEST(PlanSurroundings, WithoutHeightmapsTheSeaGoesOnBeyondTheEdge) {
  Place place = kPlace;
  place.water.sea = {{.id = {{OsmType::kWay, 1}, 0},
                      .surface = map::LandCoverClass::kSea,
                      .rings = {{{-1664, -1664}, {2048, -1664}, {2048, 0}, {-1664, 0}}}}};
  const Surroundings around = planned({}, place);
  for (const double x : {-9000.0, 0.0, 9000.0}) {
    EXPECT_EQ(cover_at(around, {x, -1000}), Cover::kSea) << x;
    EXPECT_EQ(cover_at(around, {x, -20000}), Cover::kSea) << x;
    EXPECT_EQ(cover_at(around, {x, 800}), Cover::kLand) << x;
    EXPECT_EQ(cover_at(around, {x, 20000}), Cover::kLand) << x;
  }
}

TEST(PlanSurroundings, WithoutHeightmapsTheMappedCoastBeyondTheExtentDecides) {
  // the sea is in the south; a bay of 10 km, and an island, lie east of the extent
  const Polyline coast = {{-90000, -1000}, {8000, -1000}, {8000, 9000}, {18000, 9000}, {18000, -1000}, {90000, -1000}};
  Polyline eastwards = coast;
  const Polyline island = {{12000, 2000}, {14000, 2000}, {14000, 4000}, {12000, 4000}, {12000, 2000}};
  const std::vector<Polyline> coasts = {eastwards, island};
  Place place = kPlace;
  place.water.coast = CoastSides(coasts);
  const Surroundings around = planned({}, place);
  for (std::size_t i = 0; i < around.covers.size(); ++i) {
    const Vec2 p = around.vertex(i % around.columns(), i / around.columns());
    if (kPlace.extent.contains(p)) continue;
    const bool is_bay =
        p.x > 8000 && p.x < 18000 && p.y<9000, is_island = p.x> 12000 && p.x < 14000 && p.y > 2000 && p.y < 4000;
    if (std::abs(p.x) > 40000 || std::abs(p.y) > 40000) continue;
    const bool is_sea = (p.y < -1000 || is_bay) && !is_island;
    const bool is_on_coast = CoastSides(coasts).at(p)->away_m == 0;
    EXPECT_TRUE(is_on_coast || (around.covers[i] == Cover::kSea) == is_sea) << p.x << " " << p.y;
  }
}

TEST(PlanSurroundings, ALakeAcrossTheBorderGoesOnAsFarAsHeightsAreLevel) {
  const map::Plane plane(kOrigin);
  // a lake at 176 m, with an eastern shore 20 km away
  const auto shore_m = [&](double lon_deg, double lat_deg) {
    const Vec2 p = plane.forward({lon_deg, lat_deg});
    return p.x < 1000 ? 180.0 : p.x < 22000 ? 176.0 : 176 + (p.x - 22000) * 0.01;
  };
  Place place = kPlace;
  ground::LandCoverPolygon lake{.id = {{OsmType::kRelation, 1}, 0},
                                .surface = map::LandCoverClass::kLake,
                                .rings = {{{1000, -2000}, {2300, -2000}, {2300, 1200}, {1000, 1200}}},
                                .level_m = 176.25};
  ASSERT_TRUE(reaches_beyond(lake, place.extent));
  place.water.lakes = {lake};
  const Surroundings around = planned({raster_of(shore_m)}, place);
  for (const double y : {-1000.0, 500.0}) {
    EXPECT_EQ(cover_at(around, {-1000, y}), Cover::kLand) << y;
    EXPECT_EQ(cover_at(around, {3000, y}), Cover::kLake) << y;
    EXPECT_EQ(cover_at(around, {18000, y}), Cover::kLake) << y;
    EXPECT_EQ(height_m_at(around, {15000, y}), 176) << y;
    EXPECT_EQ(cover_at(around, {30000, y}), Cover::kLand) << y;
  }
  // a lake on 400 m of the border ends
  for (Vec2& p : lake.rings[0]) p.y = p.y < 0 ? 200 : 600;
  EXPECT_FALSE(reaches_beyond(lake, place.extent));
}

TEST(PlanSurroundings, HeightmapsOfTheExtentAloneGoOnBeyondIt) {
  // 42.49 to 42.52 by 1.5 to 1.53 is not more than the extent
  source::Raster small = raster_of(hills_m, 1.502, 1.542);
  small.from_grid[3] = 42.517, small.rows = 6;
  small.heights_m.resize(static_cast<std::size_t>(small.rows) * small.columns);
  const Surroundings around = planned({small});
  ASSERT_FALSE(around.is_empty());
  const auto [low_m, high_m] = std::ranges::minmax(around.heights_m);
  EXPECT_GT(low_m, 400);
  EXPECT_LT(high_m, 2500);
}

TEST(PlanSurroundings, WhereNoHeightIsKnownNoWallStands) {
  // heightmaps reach to 1.6° only, some 4 km east of the extent
  const Surroundings around = planned({raster_of(hills_m, 0.7, 1.6)});
  ASSERT_FALSE(around.is_empty());
  double steepest = 0;
  const std::size_t row = around.rows() / 2;
  for (std::size_t i = 1; i < around.columns(); ++i) {
    const double rise_m = around.heights_m[around.index(i, row)] - around.heights_m[around.index(i - 1, row)];
    if (around.x_m[i - 1] >= 6500)
      steepest = std::max(steepest, std::abs(rise_m) / (around.x_m[i] - around.x_m[i - 1]));
  }
  EXPECT_GT(around.x_m.back(), 60000);
  EXPECT_LT(steepest, 0.4);
  // far from all heightmaps the land is at the mean
  double mean_m = 0;
  for (const std::int32_t height : around.heights_m) mean_m += height / static_cast<double>(around.heights_m.size());
  EXPECT_NEAR(around.heights_m[around.index(around.columns() - 1, row)], mean_m, 60);
}

TEST(PlanSurroundings, SeaStaysSeaAndOnlyWhereThereIsACoast) {
  const auto coast_m = [](double, double lat_deg) { return lat_deg < 42.3 ? 0 : 2000 * (lat_deg - 42.3) + 3; };
  // heightmaps reach to 1.6° only
  const std::vector<source::Raster> rasters = {raster_of(coast_m, 0.7, 1.6)};
  Place by_sea = kPlace;
  // a bay in the extent, whose ground is above 0 in the heightmap
  const Box2 bay{{-1700, -1700}, {-1000, -1000}};
  by_sea.water.sea = {{.id = {{OsmType::kWay, 1}, 0},
                       .surface = map::LandCoverClass::kSea,
                       .rings = {{bay.min, {bay.max.x, bay.min.y}, bay.max, {bay.min.x, bay.max.y}}}}};
  const Surroundings around = planned(rasters, by_sea);
  int seas = 0;
  for (std::size_t i = 0; i < around.covers.size(); ++i) {
    const bool is_south = around.vertex(0, i / around.columns()).y < -26000;
    EXPECT_EQ(around.covers[i] == Cover::kSea, around.heights_m[i] == 0);
    const Vec2 p = around.vertex(i % around.columns(), i / around.columns());
    EXPECT_TRUE(!kPlace.extent.contains(p) || (around.covers[i] == Cover::kSea) == bay.contains(p))
        << p.x << " " << p.y;
    EXPECT_TRUE(!is_south || around.covers[i] == Cover::kSea) << i;
    seas += around.covers[i] == Cover::kSea;
  }
  EXPECT_GT(seas, 1000);
  const Surroundings inland = planned(rasters);
  EXPECT_EQ(std::ranges::count(inland.covers, Cover::kSea), 0);
}

TEST(PlanSurroundingsReal, AndorraIsWithinItsStatedErrors) {
  const std::string path = real_data("andorra/N42E001.hgt");
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is absent";
  const map::Plane plane(kOrigin);
  const source::LonLatBox window = map::lonlat_box_of(kPlace.extent.widened(kReach_m), plane);
  Report report;
  std::vector<source::RasterSpec> specs(1);
  specs[0].path = path;
  const auto rasters = source::read_heightmaps(specs, &window, report, kSampleSpacing_m);
  ASSERT_TRUE(rasters);
  const Surroundings around = planned(*rasters);
  ASSERT_FALSE(around.is_empty());
  // the Pic de Médécourbe (2,914 m) is 13 km to the north-west, Coma Pedrosa (2,942 m) is the country's highest
  EXPECT_GT(*std::ranges::max_element(around.heights_m), 2800);
  // by distance: half of what stands out is lower than 0.5° for an eye in the extent
  struct Band {
    double from_m, rms_m = 0, count = 0;
  } bands[] = {{0}, {1000}, {4000}, {16000}, {32000}, {60000}};
  const source::Raster& raster = rasters->front();
  for (int r = 0; r < raster.rows; ++r)
    for (int c = 0; c < raster.columns; ++c) {
      const auto& g = raster.from_grid;
      const Vec2 p = plane.forward({g[0] + g[1] * c, g[3] + g[5] * r});
      const double away = away_m(kPlace.extent, p);
      if (away == 0 || !around.box().contains(p)) continue;
      const double error_m = height_m_at(around, p) - raster.at(c, r);
      EXPECT_LE(std::abs(error_m), around.error_m);
      Band* band = bands;
      while (away >= band[1].from_m && band[1].from_m < 60000) ++band;
      band->rms_m += error_m * error_m, ++band->count;
    }
  for (Band& band : bands) {
    if (band.count == 0) continue;
    band.rms_m = std::sqrt(band.rms_m / band.count);
    std::printf("from %.0f m: root mean square %.1f m of %.0f samples\n", band.from_m, band.rms_m, band.count);
  }
  std::printf("%zu x %zu, largest error %.0f m, root mean square %.0f m\n", around.columns(), around.rows(),
              around.error_m, around.rms_error_m);
  EXPECT_LT(bands[0].rms_m, 12);
  EXPECT_LT(bands[1].rms_m, 40);
  EXPECT_LT(bands[3].rms_m / 16000, 0.01);
}

TEST(IsSound, RefusesGridsThatCompileDoesNotPlan) {
  const Surroundings good{
      .x_m = {0, 10}, .y_m = {0, 10}, .heights_m = {1, 2, 3, 4}, .covers = std::vector(4, Cover::kLand)};
  EXPECT_TRUE(is_sound(good));
  EXPECT_TRUE(is_sound({}));
  const auto broken = [&](auto change) {
    Surroundings bad = good;
    change(bad);
    return is_sound(bad);
  };
  EXPECT_FALSE(broken([](Surroundings& s) { s.x_m = {10, 10}; }));
  EXPECT_FALSE(broken([](Surroundings& s) { s.x_m = {0}; }));
  EXPECT_FALSE(broken([](Surroundings& s) { s.y_m[1] = 2000000; }));
  EXPECT_FALSE(broken([](Surroundings& s) { s.heights_m[2] = 20000; }));
  EXPECT_FALSE(broken([](Surroundings& s) { s.covers.pop_back(); }));
  EXPECT_FALSE(broken([](Surroundings& s) { s.error_m = std::nan(""); }));
  EXPECT_FALSE(broken([](Surroundings& s) { s.rms_error_m = -1; }));
}

}  // namespace
}  // namespace citykiln::surroundings
