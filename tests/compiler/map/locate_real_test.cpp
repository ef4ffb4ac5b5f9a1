// Every real extract: guarantees for all, and known places.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "compiler/geometry/snap.h"
#include "compiler/map/heights/resample.h"
#include "compiler/source/read_osm.h"
#include "compiler/source/read_raster.h"
#include "compiler/source/voids/fill_gaps.h"
#include "tests/compiler/map/map_text.h"
#include "tests/test_files.h"

namespace citykiln::map {
namespace {

namespace fs = std::filesystem;

#define NEEDS_DATA() \
  if (!fs::exists(real_data())) GTEST_SKIP() << "no real data at " << real_data()

bool is_extract(const fs::path& path) {
  const std::string name = path.filename().string();
  for (const char* end : {".osm", ".osm.pbf", ".osm.gz", ".osm.bz2"})
    if (name.ends_with(end)) return true;
  return false;
}

std::vector<std::string> all_extracts() {
  std::vector<std::string> paths;
  for (const auto& entry : fs::recursive_directory_iterator(real_data()))
    if (is_extract(entry.path())) paths.push_back(entry.path().string());
  std::sort(paths.begin(), paths.end());
  return paths;
}

struct Located {
  source::OsmData osm;
  Plane plane{LonLat{}};
  Features features;
  Report report;

  bool is_sea(LonLat place) const {
    const Vec2 p = plane.forward(place);
    for (const AreaFeature& area : features.areas)
      if (area.surface == LandCoverClass::kSea && contains(area.polygon, p)) return true;
    return false;
  }
  // The share of the region, by 100 × 100 samples.
  double sea_share() const {
    int sea = 0;
    for (int i = 0; i < 100; ++i)
      for (int j = 0; j < 100; ++j) {
        const Box2& r = features.extent;
        sea += is_sea(plane.backward({r.min.x + (i + 0.5) * r.width() / 100, r.min.y + (j + 0.5) * r.height() / 100}));
      }
    return sea / 10000.0;
  }
};

Located located_file(const std::string& path) {
  Report reading;
  auto osm = source::read_osm(path, 2, reading);
  EXPECT_TRUE(osm) << path;
  if (!osm) return {};
  const source::LonLatBox box = choose_box(*osm, {});
  Located located{std::move(*osm), Plane(default_origin(box)), {}, {}};
  located.features = locate(located.osm, located.plane, box, {}, located.report);
  return located;
}

Located located_extract(const char* name) { return located_file(real_data(name)); }

template <typename Feature>
bool ids_rise(const std::vector<Feature>& features) {
  return std::adjacent_find(features.begin(), features.end(),
                            [](const Feature& a, const Feature& b) { return !(a.id < b.id); }) == features.end();
}

void expect_good_polygon(const Polygon& polygon, const Box2& far, ObjectId id) {
  EXPECT_GE(polygon.outer.size(), 3u) << to_string(id.osm);
  for (const Vec2 p : polygon.outer) {
    ASSERT_EQ(p, snapped(p)) << to_string(id.osm);
    ASSERT_TRUE(far.contains(p)) << to_string(id.osm);
  }
}

TEST(LocateReal, EveryExtractKeepsTheGuarantees) {
  NEEDS_DATA();
  const auto paths = all_extracts();
  ASSERT_FALSE(paths.empty());
  std::size_t located_features = 0;  // some test files hold none
  for (const std::string& path : paths) {
    SCOPED_TRACE(path);
    const Located located = located_file(path);
    const Features& f = located.features;
    located_features += f.tracks.size() + f.footprints.size() + f.areas.size();
    EXPECT_TRUE(located.report.balances());
    EXPECT_TRUE(ids_rise(f.tracks) && ids_rise(f.footprints) && ids_rise(f.areas) && ids_rise(f.waterways) &&
                ids_rise(f.barriers) && ids_rise(f.points));
    const Box2 far = f.extent.widened(65536);
    for (const AreaFeature& area : f.areas) expect_good_polygon(area.polygon, far, area.id);
    for (const Footprint& footprint : f.footprints) {
      expect_good_polygon(footprint.polygon, far, footprint.id);
      EXPECT_GT(footprint.height_m, footprint.min_height_m) << to_string(footprint.id.osm);
    }
    for (const Track& track : f.tracks) {
      EXPECT_EQ(track.axis.size(), track.node_ids.size());
      EXPECT_GE(track.axis.size(), 2u);
      EXPECT_GT(carriageway_width_m(track.section), 0);
      EXPECT_TRUE(box_of(track.axis).touches(f.extent));
    }
  }
  EXPECT_GT(located_features, 0u);
}

TEST(LocateReal, ShuffledElementsGiveTheSameFeatures) {
  NEEDS_DATA();
  for (const char* name : {"monaco/monaco-2023.osm.pbf", "helsinki/Helsinki.osm.pbf", "niteroi/niteroi.osm.pbf"}) {
    Located located = located_extract(name);
    std::reverse(located.osm.ways.begin(), located.osm.ways.end());
    std::reverse(located.osm.areas.begin(), located.osm.areas.end());
    std::reverse(located.osm.nodes.begin(), located.osm.nodes.end());
    const source::LonLatBox box = choose_box(located.osm, {});
    Report report;
    EXPECT_EQ(text_of(locate(located.osm, located.plane, box, {}, report)), text_of(located.features)) << name;
  }
}

// Ways, relations and parts as counted by osmium (data/INDEX.md); one in Chicago is building=no. Shelters and covered
// platforms without building=* are added last.
TEST(LocateReal, FootprintsAreCountedByTags) {
  NEEDS_DATA();
  const struct {
    const char* name;
    std::uint64_t footprints;
  } cases[] = {{"andorra/andorra-2023.osm.pbf", 5721 + 38},
               {"chicago-loop/chicago_loop.osm.pbf", 1573 + 21 + 389 - 1 + 10},
               {"berlin/berlin-neukolln.osm", 126 + 1 + 83 + 1},
               {"berlin/berlin-siegessaeule.osm.gz", 5 + 118},
               {"berlin/berlin-reinickendorf-2026.osm.pbf", 3715 + 5 + 64 + 2},
               {"small/somes-island.osm.pbf", 17},
               {"small/West-Oakland.osm.bz2", 23},
               {"small/frederiksted.osm.pbf", 325}};
  for (const auto& c : cases)
    EXPECT_EQ(located_extract(c.name).report.account("map", "footprint").in, c.footprints) << c.name;
}

// Points by kind.
using PointCounts = std::array<int, static_cast<std::size_t>(TrackPointKind::kCount)>;

// Nodes of highways, railways and aeroways of track_rules.inc inside a box, once for each way, as counted by a script
// over `osmium cat -f osm`.
TEST(LocateReal, TrackPointsMatchTheTags) {
  NEEDS_DATA();
  const struct {
    const char* name;
    source::LonLatBox box;
    PointCounts counts;
  } cases[] = {{"helsinki/Helsinki.osm.pbf",
                {24.9353, 60.1643, 24.9533, 60.179},
                {371, 913, 179, 0, 20, 12, 2, 0, 0, 0, 0, 7, 0, 0}},
               {"berlin/berlin-neukolln.osm",
                {13.4255, 52.4696, 13.4477, 52.4848},
                {2, 11, 4, 0, 0, 0, 0, 0, 0, 26, 0, 2, 0, 0}},
               {"monaco/monaco-2023.osm.pbf",
                {7.409, 43.723, 7.449, 43.752},
                {654, 250, 26, 10, 49, 0, 4, 2, 0, 15, 1, 4, 2, 0}},
               {"chicago-loop/chicago_loop.osm.pbf",
                {-87.6384, 41.8676, -87.6054, 41.8907},
                {1294, 1677, 1096, 147, 2, 73, 11, 0, 1, 477, 9, 12, 0, 0}}};
  for (const auto& c : cases) {
    const Located located = located_extract(c.name);
    PointCounts counts{};
    for (const Track& track : located.features.tracks)
      for (const TrackPoint& point : track.points) {
        const LonLat at = located.plane.backward(track.axis[point.vertex]);
        const bool is_inside = at.lon_deg >= c.box.west && at.lon_deg <= c.box.east && at.lat_deg >= c.box.south &&
                               at.lat_deg <= c.box.north;
        counts[static_cast<std::size_t>(point.kind)] += is_inside ? 1 : 0;
      }
    EXPECT_EQ(counts, c.counts) << c.name;
  }
}

TEST(LocateReal, MonacosSeaIsSeaAndItsRockIsNot) {
  NEEDS_DATA();
  for (const char* name : {"monaco/monaco-2023.osm.pbf", "monaco/monaco-2016-cadastre.osm.pbf"}) {
    const Located monaco = located_extract(name);
    EXPECT_TRUE(monaco.is_sea({7.4255, 43.7350})) << "Port Hercule";
    EXPECT_TRUE(monaco.is_sea({7.4400, 43.7300})) << "open sea";
    EXPECT_FALSE(monaco.is_sea({7.4280, 43.7392})) << "casino";
    EXPECT_FALSE(monaco.is_sea({7.4203, 43.7313})) << "palace";
    EXPECT_FALSE(monaco.is_sea({7.4130, 43.7395})) << "hillside";
  }
  // 0.4897 by two independent implementations
  EXPECT_NEAR(located_extract("monaco/monaco-2023.osm.pbf").sea_share(), 0.49, 0.01);
}

TEST(LocateReal, SomesIslandStandsInTheSea) {
  NEEDS_DATA();
  const Located somes = located_extract("small/somes-island.osm.pbf");
  EXPECT_FALSE(somes.is_sea({174.8655, -41.2572}));
  EXPECT_TRUE(somes.is_sea({174.8600, -41.2500}));
  EXPECT_TRUE(somes.is_sea({174.8700, -41.2630}));
  EXPECT_NEAR(somes.sea_share(), 0.862, 0.01);
}

TEST(LocateReal, BaysAndRiversOfCoastAreSeaOnTheRightSide) {
  NEEDS_DATA();
  const Located niteroi = located_extract("niteroi/niteroi.osm.pbf");
  EXPECT_TRUE(niteroi.is_sea({-43.1290, -22.8950})) << "Guanabara bay";
  EXPECT_FALSE(niteroi.is_sea({-43.0500, -22.9000})) << "hills";
  const Located village = located_extract("nyc/nyc-west-village.osm.pbf");
  EXPECT_TRUE(village.is_sea({-74.0132, 40.7365})) << "Hudson";
  EXPECT_FALSE(village.is_sea({-74.0030, 40.7360})) << "Greenwich Village";
}

TEST(LocateReal, AnExtractWithoutCoastHasNoSea) {
  NEEDS_DATA();
  for (const char* name :
       {"chicago-loop/chicago_loop.osm.pbf", "andorra/cut-andorra-la-vella.osm.pbf", "berlin/berlin-neukolln.osm"})
    EXPECT_EQ(located_extract(name).sea_share(), 0) << name;
}

// No header box; its lake reaches to latitude 46.
TEST(LocateReal, ChicagosBoxIsThatOfItsBuildings) {
  NEEDS_DATA();
  const Located chicago = located_extract("chicago-loop/chicago_loop.osm.pbf");
  const source::LonLatBox box = choose_box(chicago.osm, {});
  EXPECT_NEAR(box.south, 41.8676, 0.003);
  EXPECT_NEAR(box.north, 41.8907, 0.003);
  EXPECT_NEAR(box.west, -87.6384, 0.003);
  EXPECT_NEAR(box.east, -87.6054, 0.003);
  // Lake Michigan is east of the shore
  const Vec2 lake = chicago.plane.forward({-87.6065, 41.8800});
  bool is_lake = false;
  for (const AreaFeature& area : chicago.features.areas)
    is_lake = is_lake || (values_of(area.surface).group == LandCoverGroup::kWater && contains(area.polygon, lake));
  EXPECT_TRUE(is_lake);
}

TEST(LocateReal, ChicagosTowersHaveTheirHeights) {
  NEEDS_DATA();
  double highest = 0;
  for (const Footprint& footprint : located_extract("chicago-loop/chicago_loop.osm.pbf").features.footprints)
    highest = std::max(highest, footprint.height_m);
  EXPECT_EQ(highest, 527);  // Willis Tower with its antennas
}

Heightfield heights_of(const Located& located, const std::string& dem, Report& report) {
  const Box2& r = located.features.extent;
  const LonLat low = located.plane.backward(r.min), high = located.plane.backward(r.max);
  const source::LonLatBox window{low.lon_deg - 0.01, low.lat_deg - 0.01, high.lon_deg + 0.01, high.lat_deg + 0.01};
  source::RasterSpec spec;
  spec.path = real_data(dem);
  auto raster = source::read_raster(spec, &window);
  EXPECT_TRUE(raster) << dem;
  if (!raster) return {};
  auto field = resample(std::vector{source::fill_voids(std::move(*raster), report)}, located.plane, r, report);
  EXPECT_TRUE(field) << dem;
  return field ? std::move(*field) : Heightfield{};
}

TEST(ResampleReal, AndorrasHeightsAreWhereTheyAre) {
  NEEDS_DATA();
  Report report;
  const Located andorra = located_extract("andorra/andorra-2023.osm.pbf");
  const Heightfield field = heights_of(andorra, "andorra/N42E001.hgt", report);
  ASSERT_GT(field.columns, 2);
  EXPECT_EQ(field.sample_step_m(), (Vec2{68.375, 92.5}));
  EXPECT_EQ(field.parts, 4);
  EXPECT_NEAR(height_m_at(field, andorra.plane.forward({1.5218, 42.5070})), 1023, 40) << "Andorra la Vella";
  // Coma Pedrosa's sample: row 490, column 532 of N42E001.hgt, 2911 m (the true summit, 2943 m, is sharper than 3″)
  EXPECT_NEAR(height_m_at(field, andorra.plane.forward({1 + 532 / 1200.0, 43 - 490 / 1200.0})), 2911,
              field.resampling_error_m);
  EXPECT_EQ(report.counts()[Code::kNoHeight], 0u);
  EXPECT_GT(field.resampling_error_m, 0);
  EXPECT_LT(field.resampling_error_m, 100);
}

TEST(ResampleReal, MonacosSeaLiesAtSeaLevel) {
  NEEDS_DATA();
  Report report;
  const Located monaco = located_extract("monaco/monaco-2023.osm.pbf");
  const Heightfield field = heights_of(monaco, "monaco/N43E007.hgt", report);
  ASSERT_GT(field.columns, 2);
  EXPECT_NEAR(height_m_at(field, monaco.plane.forward({7.4400, 43.7300})), 0, 3);
  EXPECT_GT(height_m_at(field, monaco.plane.forward({7.4120, 43.7420})), 100);
}

TEST(ResampleReal, AHeightmapOfAnotherCountryIsOneClearLine) {
  NEEDS_DATA();
  const Located berlin = located_extract("berlin/berlin-neukolln.osm");
  source::RasterSpec spec;
  spec.path = real_data("andorra/N42E001.hgt");
  const auto raster = source::read_raster(spec, nullptr);
  ASSERT_TRUE(raster);
  Report report;
  const auto field = resample(std::vector{*raster}, berlin.plane, berlin.features.extent, report);
  ASSERT_FALSE(field);
  EXPECT_EQ(field.error().where, "N42E001.hgt");
  EXPECT_EQ(field.error().message.find('\n'), std::string::npos);
}

}  // namespace
}  // namespace citykiln::map
