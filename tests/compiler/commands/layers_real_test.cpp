// Layers of real extracts, read as GeoJSON by GEOS, which is independent of what makes them.
#include <geos_c.h>
#include <gtest/gtest.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "compiler/commands/layers/geojson.h"
#include "compiler/commands/layers/map_layers.h"
#include "compiler/commands/layers/scene_layers.h"
#include "compiler/source/read_osm.h"
#include "tests/compiler/real_scenes.h"
#include "tests/test_files.h"

namespace citykiln::commands {
namespace {

using Shape = std::unique_ptr<GEOSGeometry, decltype([](GEOSGeometry* g) { GEOSGeom_destroy(g); })>;

void keep_silent(const char*, ...) {}

struct Geos {
  Geos() { initGEOS(keep_silent, keep_silent); }
  ~Geos() { finishGEOS(); }
};

/// A feature as other programs read it.
struct ReadFeature {
  nlohmann::json properties;
  Shape shape;
};

/// GEOS reads two coordinates only.
void drop_heights(nlohmann::json& coordinates) {
  if (coordinates.front().is_number())
    coordinates.get_ref<nlohmann::json::array_t&>().resize(2);
  else
    for (auto& part : coordinates) drop_heights(part);
}

std::vector<ReadFeature> read_back(const Layer& layer, const map::Plane& plane) {
  auto collection = nlohmann::json::parse(geojson_of(layer, plane, {}));
  GEOSGeoJSONReader* reader = GEOSGeoJSONReader_create();
  std::vector<ReadFeature> features;
  for (auto& feature : collection["features"]) {
    drop_heights(feature["geometry"]["coordinates"]);
    Shape shape(GEOSGeoJSONReader_readGeometry(reader, feature["geometry"].dump().c_str()));
    EXPECT_TRUE(shape) << feature;
    if (shape) features.push_back({feature["properties"], std::move(shape)});
  }
  GEOSGeoJSONReader_destroy(reader);
  return features;
}

void expect_valid(const std::vector<ReadFeature>& features, const std::string& what, std::size_t least) {
  EXPECT_GE(features.size(), least) << what;
  for (const ReadFeature& feature : features) {
    if (GEOSisValid(feature.shape.get()) == 1) continue;
    char* reason = GEOSisValidReason(feature.shape.get());
    ADD_FAILURE() << what << " " << feature.properties << " " << reason;
    GEOSFree(reason);
  }
}

void expect_each_once(const std::vector<ReadFeature>& features, const std::string& what) {
  std::set<std::string> seen;
  for (const ReadFeature& feature : features) {
    const auto& p = feature.properties;
    const std::string object = p["id"].get<std::string>() + "/" + p["part"].dump() + p["class"].dump();
    EXPECT_TRUE(seen.insert(object).second) << what << " " << p;
  }
}

/// A hundredth of a square metre in square degrees at the equator, where degrees are longest. Shared borders of ten
/// metres, rounded to 1e-9 degrees, share a tenth of it.
constexpr double kNoArea = 0.01 / (111320.0 * 111320.0);

/// The number of pairs of features that share more area than that.
int overlaps(const std::vector<ReadFeature>& features) {
  GEOSSTRtree* tree = GEOSSTRtree_create(10);
  for (const ReadFeature& feature : features)
    GEOSSTRtree_insert(tree, feature.shape.get(), const_cast<ReadFeature*>(&feature));
  struct Search {
    const ReadFeature* feature;
    int overlaps = 0;
  } search{};
  for (const ReadFeature& feature : features) {
    search.feature = &feature;
    GEOSSTRtree_query(
        tree, feature.shape.get(),
        [](void* item, void* data) {
          auto& of = *static_cast<Search*>(data);
          const auto* other = static_cast<const ReadFeature*>(item);
          if (other <= of.feature) return;
          const Shape both(GEOSIntersection(of.feature->shape.get(), other->shape.get()));
          double area = 0;
          if (both) GEOSArea(both.get(), &area);
          if (area > kNoArea) ++of.overlaps;
        },
        &search);
  }
  GEOSSTRtree_destroy(tree);
  return search.overlaps;
}

struct Case {
  Extract extract;
  std::size_t areas, buildings, junctions;
};

// tiles of 256 m: many objects lie in several
constexpr double kTile_m = 256;
const Case kCases[] = {{{"monaco/monaco-2023.osm.pbf", "monaco/N43E007.hgt"}, 300, 1200, 500},
                       {{"boston-back-bay/back_bay.osm.pbf"}, 300, 300, 1500},
                       {{"helsinki/Helsinki.osm.pbf"}, 50, 400, 500}};

class LayersReal : public testing::TestWithParam<Case> {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(real_data(GetParam().extract.map)))
      GTEST_SKIP() << "absent: " << GetParam().extract.map;
  }
  Geos geos_;
};

TEST_P(LayersReal, OfAMapAreValid) {
  Report report;
  const Result<source::OsmData> osm = source::read_osm(real_data(GetParam().extract.map), 2, report);
  ASSERT_TRUE(osm);
  const source::LonLatBox box = map::choose_box(*osm, {});
  const map::Plane plane(map::default_origin(box));
  const map::Features features = map::locate(*osm, plane, box, {}, report);
  const auto& [extract, areas, buildings, junctions] = GetParam();
  expect_valid(read_back(*layer_of(features, "areas"), plane), "areas", areas);
  expect_valid(read_back(*layer_of(features, "buildings"), plane), "buildings", buildings);
  expect_valid(read_back(*layer_of(features, "junctions"), plane), "junctions", junctions);
}

TEST_P(LayersReal, OfAManifestAreValidAndHoldEachObjectOnce) {
  const scene::Scene scene = scene_of(GetParam().extract, kTile_m);
  const map::Plane plane(scene.header.origin);
  const auto read = [&](const char* name) { return read_back(*layer_of(scene, name), plane); };
  const auto areas = read("areas"), buildings = read("buildings"), junctions = read("junctions"), roads = read("roads");
  expect_valid(areas, "areas", GetParam().areas);
  expect_valid(buildings, "buildings", GetParam().buildings);
  expect_valid(junctions, "junctions", GetParam().junctions);
  expect_each_once(areas, "areas"), expect_each_once(buildings, "buildings"), expect_each_once(roads, "roads");
  EXPECT_GE(roads.size(), GetParam().junctions / 2);
  EXPECT_EQ(overlaps(junctions), 0);
}

INSTANTIATE_TEST_SUITE_P(Extracts, LayersReal, testing::ValuesIn(kCases), [](const testing::TestParamInfo<Case>& info) {
  const std::string path = info.param.extract.map;
  std::string name = path.substr(0, path.find('/'));
  std::erase(name, '-');
  return name;
});

}  // namespace
}  // namespace citykiln::commands
