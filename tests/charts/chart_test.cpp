#include "tests/charts/chart.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "tests/scratch_folder.h"
#include "tests/test_files.h"

namespace citykiln::charts {
namespace {

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(Chart, WritesEverySeriesAsTableAndPicture) {
  const ScratchFolder folder;
  const Chart chart{"chart",
                    "It's a title",
                    {"x (m)", true},
                    {"y (m)", true},
                    {{"ours", {{1, 2}, {10, 20}}}, {"theirs", {{3, 4}}, true}}};
  const Result<Done> done = write_chart(chart, folder.path());
  EXPECT_EQ(text_of(folder.at("chart.csv")), "series,x (m),y (m)\nours,1,2\nours,10,20\ntheirs,3,4\n");
  if (done) {
    const std::string svg = text_of(folder.at("chart.svg"));
    for (const char* word : {"<svg", "It's a title", "ours", "theirs"})
      EXPECT_NE(svg.find(word), std::string::npos) << word;
  }
  if (!done) GTEST_SKIP() << to_string(done.error());
}

TEST(Chart, DrawsZerosOnLogarithmicAxes) {
  const ScratchFolder folder;
  const auto written = [&](double y) {
    return write_chart({"zeros", "", {"x", true}, {"y", true}, {{"flat", {{11, y}, {11, y}}}}}, folder.path());
  };
  if (!written(1)) GTEST_SKIP() << "gnuplot is not installed";
  const Result<Done> done = written(0);
  EXPECT_TRUE(done) << to_string(done.error());
}

TEST(ChartOfThePlane, ShowsTheErrorBoundOfThePlane) {
  // scale error at the rim: under 8 ppm within 25 km
  const Result<std::vector<Chart>> charts = chart_plane({});
  ASSERT_TRUE(charts);
  for (const auto& [distance_km, error_ppm] : charts->front().series.front().points) {
    if (distance_km <= 25) {
      EXPECT_LT(error_ppm, 8) << distance_km;
    }
  }
  // angles are true: what is left is the step's own length
  for (const auto& [distance_km, error_deg] : charts->back().series.front().points)
    EXPECT_LT(error_deg, 1e-4) << distance_km;
}

TEST(ChartOfJunctions, AsksForMaps) {
  EXPECT_EQ(to_string(chart_junctions({}).error()), "chart junctions: needs maps (--map FILE)");
}

TEST(ChartOfRoofs, HasFailuresAndTimeOfEveryMethod) {
  ChartRequest request;
  request.maps = {source_file("tests/golden/crossing/map.osm")};
  const Result<std::vector<Chart>> charts = chart_roof(request);
  ASSERT_TRUE(charts) << to_string(charts.error());
  ASSERT_EQ(charts->size(), 2u);
  for (const Chart& chart : *charts) {
    EXPECT_EQ(chart.series.size(), 9u);
    for (const Series& series : chart.series) EXPECT_FALSE(series.points.empty()) << series.name;
  }
  for (const Series& series : charts->front().series)
    for (const auto& [corners, percent] : series.points) EXPECT_EQ(percent, 0) << series.name;
}

TEST(ChartOfFacades, AsksForHouses) {
  ChartRequest request;
  EXPECT_FALSE(chart_facade(request));
}

TEST(ChartOfJunctions, NeverFindsSnapRoundingInvalid) {
  ChartRequest request;
  request.maps = {source_file("tests/golden/crossing/map.osm")};
  const Result<std::vector<Chart>> charts = chart_junctions(request);
  ASSERT_TRUE(charts) << to_string(charts.error());
  for (const auto& [grid_m, share] : charts->front().series.back().points) EXPECT_EQ(share, 0) << grid_m;
}

TEST(ChartOfRoads, AsksForMaps) {
  EXPECT_EQ(to_string(chart_roads({}).error()), "chart roads: needs maps (--map FILE)");
}

TEST(ChartOfRoads, MeasuresNestedPartsUpToAllRoads) {
  ChartRequest request;
  request.maps = {source_file("tests/golden/crossing/map.osm")};
  const Result<std::vector<Chart>> charts = chart_roads(request);
  ASSERT_TRUE(charts) << to_string(charts.error());
  for (const Chart& chart : *charts) {
    const auto& points = chart.series.front().points;
    ASSERT_FALSE(points.empty()) << chart.name;
    for (std::size_t i = 1; i < points.size(); ++i) EXPECT_LT(points[i - 1].first, points[i].first) << chart.name;
    for (const auto& [size, seconds] : points) EXPECT_GT(seconds, 0) << chart.name << " " << size;
  }
}

TEST(ChartOfRoads, FindsTheExponentOfAPowerLaw) {
  EXPECT_NEAR(exponent_of({"", {{1, 3}, {4, 24}, {16, 192}}}), 1.5, 1e-12);
  EXPECT_NEAR(exponent_of({"", {{10, 5}, {20, 10}, {80, 40}}}), 1, 1e-12);
  EXPECT_EQ(exponent_of({"", {{7, 1}}}), 0);
}

TEST(ChartOfTerrain, AsksForAHeightmap) {
  EXPECT_EQ(to_string(chart_terrain({}).error()), "chart terrain: needs a heightmap (--dem FILE)");
}

TEST(ChartOfLsystems, CountsSymbolsLikeTheBookAndMeshesInProportion) {
  const Result<std::vector<Chart>> charts = chart_lsystem({});
  ASSERT_TRUE(charts);
  ASSERT_EQ(charts->size(), 3u);
  const auto& growth = (*charts)[1].series;
  EXPECT_EQ(growth[0].points, growth[1].points);
  EXPECT_GT(growth[0].points.back().second, 500'000);
  // triangles double with each step, as segments do
  const auto& meshed = (*charts)[2].series[0].points;
  for (std::size_t i = 1; i < meshed.size(); ++i) EXPECT_NEAR(meshed[i].first / meshed[i - 1].first, 2, 0.1);
}

}  // namespace
}  // namespace citykiln::charts
