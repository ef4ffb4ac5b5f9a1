// The real extracts of ../shared/data.
#include <fmt/format.h>
#include <geos_c.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/compiler/source/extract_text.h"
#include "tests/test_files.h"

namespace citykiln::source {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> all_extracts() {
  std::vector<std::string> paths;
  if (!fs::exists(real_data())) return paths;
  for (const auto& entry : fs::recursive_directory_iterator(real_data())) {
    const std::string path = entry.path().string();
    if (path.find("osm-testdata") != std::string::npos) continue;
    for (const char* suffix : {".osm", ".osm.gz", ".osm.bz2", ".pbf"}) {
      if (path.ends_with(suffix)) paths.push_back(path);
    }
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

#define READ_OR_SKIP(data, report, file, threads)                                  \
  const std::string path_of_##data = real_data(file);                              \
  if (!fs::exists(path_of_##data)) GTEST_SKIP() << path_of_##data << " is absent"; \
  Report report;                                                                   \
  const Result<OsmData> data = read_osm(path_of_##data, threads, report);          \
  ASSERT_TRUE(data) << to_string(data.error())

TEST(ReadOsmReal, HelsinkisMissingNodesAreAllCounted) {
  READ_OR_SKIP(data, report, "helsinki/Helsinki.osm.pbf", 2);
  EXPECT_EQ(size_sum(report, Code::kMissingNode), 4525);
  EXPECT_TRUE(report.balances());
  for (const Way& way : data->ways) EXPECT_GE(data->nodes_of(way).size(), 2u);
}

TEST(ReadOsmReal, NewYorkIsUnsortedAndRead) {
  READ_OR_SKIP(data, report, "nyc/nyc-west-village.osm.pbf", 2);
  EXPECT_EQ(report.counts()[Code::kUnsortedFile], 1u);
  EXPECT_EQ(data->ways.size(), 1696u);
  EXPECT_EQ(data->relations.size(), 41u);
  EXPECT_TRUE(
      std::is_sorted(data->ways.begin(), data->ways.end(), [](const Way& a, const Way& b) { return a.id < b.id; }));
}

TEST(ReadOsmReal, SameDataForOneTwoAndSevenThreads) {
  READ_OR_SKIP(one, report_one, "andorra/cut-andorra-la-vella.osm.pbf", 1);
  READ_OR_SKIP(two, report_two, "andorra/cut-andorra-la-vella.osm.pbf", 2);
  READ_OR_SKIP(seven, report_seven, "andorra/cut-andorra-la-vella.osm.pbf", 7);
  EXPECT_EQ(text_of(*one), text_of(*two));
  EXPECT_EQ(text_of(*one), text_of(*seven));
  const auto texts = [](const Report& report) {
    std::string text;
    for (const Diagnosis& d : report.diagnoses())
      text += fmt::format("{} {} {}\n", name_of(d.code), to_string(d.object), d.size);
    return text;
  };
  EXPECT_EQ(texts(report_one), texts(report_two));
  EXPECT_EQ(texts(report_one), texts(report_seven));
}

TEST(ReadOsmReal, CutPbfNamesTheByte) {
  const std::string path = real_data("small/somes-island.osm.pbf");
  if (!fs::exists(path)) GTEST_SKIP() << path << " is absent";
  const std::string whole = bytes_of(path);
  const ScratchFolder folder;
  for (const std::size_t size : {whole.size() - 1, whole.size() / 2, std::size_t{100}}) {
    const std::string cut = folder.write("cut.osm.pbf", whole.substr(0, size));
    Report report;
    const Result<OsmData> data = read_osm(cut, 1, report);
    ASSERT_FALSE(data) << size;
    EXPECT_TRUE(data.error().where.starts_with(cut + ", byte ")) << to_string(data.error());
  }
}

TEST(ReadOsmReal, FlippedBytesOfAPbfEndInOneLineOrInData) {
  const std::string path = real_data("small/somes-island.osm.pbf");
  if (!fs::exists(path)) GTEST_SKIP() << path << " is absent";
  const std::string whole = bytes_of(path);
  const ScratchFolder folder;
  for (std::size_t at = 0; at < whole.size(); at += 97) {
    std::string broken = whole;
    broken[at] = static_cast<char>(broken[at] ^ 0x55);
    Report report;
    const Result<OsmData> data = read_osm(folder.write("broken.osm.pbf", broken), 1, report);
    const std::string line = data ? "" : to_string(data.error());
    EXPECT_EQ(line.find('\n'), std::string::npos) << line;
  }
}

TEST(ReadOsmReal, CutGzipAndBzip2AreErrors) {
  for (const char* file : {"berlin/berlin-siegessaeule.osm.gz", "small/West-Oakland.osm.bz2"}) {
    const std::string path = real_data(file);
    if (!fs::exists(path)) GTEST_SKIP() << path << " is absent";
    const std::string whole = bytes_of(path);
    const ScratchFolder folder;
    const std::string cut = folder.write("cut" + path.substr(path.find(".osm.")), whole.substr(0, whole.size() / 2));
    Report report;
    const Result<OsmData> data = read_osm(cut, 1, report);
    EXPECT_FALSE(data) << cut;
  }
}

// ---- areas as GEOS sees them

GEOSGeometry* ring_of(GEOSContextHandle_t geos, std::span<const Location> points) {
  GEOSCoordSequence* sequence = GEOSCoordSeq_create_r(geos, static_cast<unsigned>(points.size() + 1), 2);
  for (unsigned i = 0; i <= points.size(); ++i) {
    const Location at = points[i % points.size()];
    GEOSCoordSeq_setXY_r(geos, sequence, i, at.lon_e7, at.lat_e7);
  }
  return GEOSGeom_createLinearRing_r(geos, sequence);
}

GEOSGeometry* multipolygon_of(GEOSContextHandle_t geos, const OsmData& data, const Area& area) {
  std::vector<GEOSGeometry*> polygons;
  const auto rings = data.rings_of(area);
  for (std::size_t i = 0; i < rings.size();) {
    GEOSGeometry* outer = ring_of(geos, data.points_of(rings[i++]));
    std::vector<GEOSGeometry*> holes;
    while (i < rings.size() && !rings[i].is_outer) holes.push_back(ring_of(geos, data.points_of(rings[i++])));
    polygons.push_back(GEOSGeom_createPolygon_r(geos, outer, holes.data(), static_cast<unsigned>(holes.size())));
  }
  return GEOSGeom_createCollection_r(geos, GEOS_MULTIPOLYGON, polygons.data(), static_cast<unsigned>(polygons.size()));
}

TEST(ReadOsmReal, LedgerOfEveryExtractBalancesAndItsAreasAreValidToGeos) {
  const std::vector<std::string> paths = all_extracts();
  if (paths.empty()) GTEST_SKIP() << "no extracts in " << real_data();
  GEOSContextHandle_t geos = GEOS_init_r();
  for (const std::string& path : paths) {
    Report report;
    const Result<OsmData> data = read_osm(path, 2, report);
    ASSERT_TRUE(data) << to_string(data.error());
    EXPECT_TRUE(report.balances()) << path;
    EXPECT_EQ(report.ledger().at("source/area").out, data->areas.size()) << path;
    for (const Area& area : data->areas) {
      GEOSGeometry* shape = multipolygon_of(geos, *data, area);
      EXPECT_EQ(GEOSisValid_r(geos, shape), 1) << path << " " << to_string(area.from);
      GEOSGeom_destroy_r(geos, shape);
    }
  }
  GEOS_finish_r(geos);
}

}  // namespace
}  // namespace citykiln::source
