// Measures profiles of real places against their guarantees, as a table.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <filesystem>

#include "compiler/ground/plan.h"
#include "compiler/ground/profiles/measure_profiles.h"
#include "compiler/map/heights/resample.h"
#include "compiler/roads/roads_on_ground.h"
#include "compiler/source/read_raster.h"
#include "compiler/source/voids/fill_gaps.h"
#include "tests/compiler/roads/real_map.h"
#include "tests/test_files.h"

namespace citykiln::ground {
namespace {

struct Place {
  const char* name;
  const char* map;
  const char* heights;  ///< "": none.
  double most_over;     ///< Share of the length over its grade limit.
};

std::ostream& operator<<(std::ostream& out, const Place& place) { return out << place.name; }

class ProfilesReal : public testing::TestWithParam<Place> {};

Result<map::Heightfield> read_heights(const Place& place, const map::Plane& plane, const Box2& extent, Report& report) {
  std::vector<source::Raster> rasters;
  if (*place.heights != 0) {
    const auto spec = source::parse_raster_spec(real_data(place.heights).string());
    if (!spec) return spec.error();
    Result<source::Raster> raster = source::read_raster(*spec, nullptr);
    if (!raster) return raster.error();
    rasters.push_back(source::fill_voids(std::move(*raster), report));
  }
  return map::resample(rasters, plane, extent, report);
}

void print(const ProfileMeasures& m, double took_s) {
  std::printf(
      "%.0f km, %.3f %% over their limit; largest jump %.4f m; %llu knots; %llu crossings, %llu lacking (%llu over "
      "1 m, %llu over 3 m, largest %.1f m); %.3f s\n",
      m.length_m / 1000, 100 * m.over_m / m.length_m, m.largest_jump_m, static_cast<unsigned long long>(m.knots),
      static_cast<unsigned long long>(m.crossings), static_cast<unsigned long long>(m.shortfalls),
      static_cast<unsigned long long>(m.shortfalls_over_1_m), static_cast<unsigned long long>(m.shortfalls_over_3_m),
      m.largest_shortfall_m, took_s);
  for (const GradeMeasure& c : m.classes)
    std::printf("  %-18s %8.1f km, %6.3f %% over, steepest %.3f\n", std::string(map::values_of(c.surface).name).c_str(),
                c.length_m / 1000, 100 * c.over_m / c.length_m, c.steepest);
}

TEST_P(ProfilesReal, MeetWithoutJumpsAndKeepTheirLimits) {
  const Place place = GetParam();
  if (!std::filesystem::exists(real_data(place.map))) GTEST_SKIP() << "absent: " << place.map;
  Report report;
  const auto real = roads::read_real_map(real_data(place.map), report);
  ASSERT_TRUE(real) << to_string(real.error());
  const map::Features& features = real->features;
  const auto heights = read_heights(place, map::Plane(real->origin), features.extent, report);
  ASSERT_TRUE(heights) << to_string(heights.error());
  const auto roads = roads::roads_on_ground(features, report);
  const auto junctions = roads::plan_junctions(roads, report);
  const auto streams = plan_streams(features, report);
  const auto waters = plan(features, report);

  const auto begin = std::chrono::steady_clock::now();
  const Profiles profiles = plan_profiles(features, roads, junctions, streams, waters, *heights, report);
  const double took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const ProfileMeasures measures = measure_profiles(features, profiles);
  print(measures, took_s);
  EXPECT_GT(measures.length_m, 0);
  // paths use stored heights of streets: rounded twice
  EXPECT_LE(measures.largest_jump_m, 2 * 0.01);
  EXPECT_LE(measures.over_m, place.most_over * measures.length_m);
}

INSTANTIATE_TEST_SUITE_P(
    Places, ProfilesReal,
    testing::Values(Place{"andorra", "andorra/andorra-2023.osm.pbf", "andorra/N42E001.hgt", 0.012},
                    Place{"monaco", "monaco/monaco-2023.osm.pbf", "monaco/N43E007.hgt", 0.03},
                    Place{"berlin", "berlin/berlin-reinickendorf-2026.osm.pbf", "berlin/N52E013.hgt", 0.001},
                    Place{"portland", "portland/portland-central-filtered.osm.pbf", "portland/portland-ned.tif", 0.004},
                    Place{"chicago", "chicago-loop/chicago_loop.osm.pbf", "", 0.013},
                    Place{"porto", "porto-roads/porto_portugal.osm.pbf", "", 0.001}),
    [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace citykiln::ground
