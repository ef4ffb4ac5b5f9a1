#include "compiler/commands/layers/geojson.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "compiler/commands/layers/map_layers.h"
#include "compiler/commands/layers/scene_layers.h"

namespace citykiln::commands {
namespace {

map::Features one_of_each() {
  map::Features features;
  map::Track track;
  track.id = {{OsmType::kWay, 7}, 0};
  track.axis = {{0, 0}, {100, 0}};
  track.section = {{{map::LaneKind::kDriving, map::LaneDirection::kBoth, 5.5}}, 2.75};
  features.tracks.push_back(track);
  map::Footprint building;
  building.id = {{OsmType::kRelation, 8}, 1};
  building.polygon = {{{0, 0}, {10, 0}, {10, 10}}, {{{4, 2}, {8, 4}, {8, 2}}}};
  building.height_m = 9;
  features.footprints.push_back(building);
  return features;
}

TEST(GeoJson, LinesAreInLongitudeAndLatitudeWithTheirIds) {
  const Result<Layer> layer = layer_of(one_of_each(), "roads");
  ASSERT_TRUE(layer);
  const std::string text = geojson_of(*layer, map::Plane({10, 48}), {"© \"us\""});
  EXPECT_NE(text.find(R"("id":"w7","part":0)"), std::string::npos) << text;
  EXPECT_NE(text.find(R"("width_m":5.5)"), std::string::npos) << text;
  EXPECT_NE(text.find(R"({"type":"LineString","coordinates":[[10.000000000,48.000000000],[10.00134)"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find(R"("attribution":["© \"us\""])"), std::string::npos) << text;
}

TEST(GeoJson, RingsEndWhereTheyBegin) {
  const Result<Layer> layer = layer_of(one_of_each(), "buildings");
  ASSERT_TRUE(layer);
  const std::string text = geojson_of(*layer, map::Plane({10, 48}), {});
  EXPECT_NE(text.find(R"([[[10.000000000,48.000000000],)"), std::string::npos) << text;
  EXPECT_NE(text.find(R"([10.000000000,48.000000000]],[[)"), std::string::npos) << text;
  EXPECT_NE(text.find(R"("id":"r8","part":1)"), std::string::npos) << text;
}

TEST(GeoJson, WritesAnEmptyCollectionForAnEmptyLayer) {
  const std::string text = geojson_of(*layer_of(map::Features{}, "areas"), map::Plane({10, 48}), {});
  EXPECT_EQ(text, "{\"type\":\"FeatureCollection\",\"attribution\":[],\"features\":[\n]}\n");
}

TEST(GeoJson, JunctionsHaveTheIdOfTheirMainRoad) {
  map::Features features;
  for (const double y : {-50.0, 50.0}) {
    map::Track& track = features.tracks.emplace_back();
    track.id = {{OsmType::kWay, y < 0 ? 1 : 2}, 0};
    track.axis = {{y, 0}, {0, 0}, {0, y}};
    track.node_ids = {1, 2, 3};
    track.surface = map::LandCoverClass::kResidentialRoad;
    const double width_m = y < 0 ? 8 : 6;
    track.section = {{{map::LaneKind::kDriving, map::LaneDirection::kBoth, width_m}}, width_m / 2};
  }
  const Result<Layer> layer = layer_of(features, "junctions");
  ASSERT_TRUE(layer);
  ASSERT_EQ(layer->size(), 1u);
  EXPECT_EQ((*layer)[0].id.osm.id, 1);
}

TEST(GeoJson, JunctionsSayTheirLayer) {
  map::Features features;
  for (const int way : {1, 2, 3, 4}) {
    map::Track& track = features.tracks.emplace_back();
    track.id = {{OsmType::kWay, way}, 0};
    const double y = way % 2 == 0 ? 50 : -50;
    track.axis = {{y, 0}, {0, 0}, {0, y}};
    track.node_ids = {1, way > 2 ? 7 : 2, 3};
    track.surface = map::LandCoverClass::kResidentialRoad;
    track.section = {{{map::LaneKind::kDriving, map::LaneDirection::kBoth, 6}}, 3};
    track.passage = way > 2 ? map::Passage::kBridge : map::Passage::kGround;
    track.layer = way > 2 ? 2 : 0;
  }
  const Result<Layer> layer = layer_of(features, "junctions");
  ASSERT_TRUE(layer);
  ASSERT_EQ(layer->size(), 2u);
  const std::string text = geojson_of(*layer, map::Plane({10, 48}), {});
  EXPECT_NE(text.find(R"("id":"w2","part":0,"class":"ResidentialRoad","layer":0})"), std::string::npos) << text;
  EXPECT_NE(text.find(R"("id":"w4","part":0,"class":"ResidentialRoad","layer":2,"bridge":true})"), std::string::npos)
      << text;
}

TEST(GeoJson, PropertiesAreWhatTheMapSays) {
  map::Features features = one_of_each();
  features.texts = {{{OsmType::kWay, 7}, "Rue \"A\""}, {{OsmType::kRelation, 8}, "Hall"}};
  features.tracks[0].layer = -1, features.tracks[0].passage = map::Passage::kTunnel;
  features.footprints[0].levels = 3, features.footprints[0].has_roof_shape = true;
  const auto properties_of = [&](const char* layer) {
    return nlohmann::json::parse(
        geojson_of(*layer_of(features, layer), map::Plane({10, 48}), {}))["features"][0]["properties"];
  };
  EXPECT_EQ(properties_of("roads"), nlohmann::json::parse(R"({"id":"w7","part":0,"class":"Unknown","name":"Rue \"A\"",
      "lanes":1,"section":"d -","width_m":5.5,"surface":"UnknownGround","layer":-1,"tunnel":true})"));
  EXPECT_EQ(properties_of("buildings"), nlohmann::json::parse(R"({"id":"r8","part":1,"class":"Building","name":"Hall",
      "levels":3,"roof":"flat","height_m":9})"));
}

TEST(GeoJson, PolygonsThatCrossThemselvesAreMended) {
  map::Features features = one_of_each();
  features.footprints[0].polygon = {{{0, 0}, {16, 16}, {16, 0}, {0, 16}}, {}};
  features.extent = {{0, 0}, {128, 128}};
  features.areas.push_back({{{OsmType::kWay, 3}, 0}, {{{-64, 8}, {64, 8}, {64, 24}, {-64, 24}}, {}}, {}, 2048});
  const Result<Layer> buildings = layer_of(features, "buildings"), areas = layer_of(features, "areas");
  ASSERT_EQ(buildings->size(), 1u);
  ASSERT_EQ(areas->size(), 1u);
  EXPECT_EQ((*buildings)[0].parts[0][0].size(), 3u);
  for (const Vec3 p : (*areas)[0].parts[0][0]) EXPECT_GE(p.x, 0) << "clipped to the region";
}

TEST(GeoJson, RoadsOfSeveralTilesAreOneWithHeights) {
  scene::Scene scene;
  scene.header.extent = {{0, 0}, {256, 128}}, scene.header.tile_m = 128;
  roads::Road road;
  road.id = {{OsmType::kWay, 7}, 0};
  road.section = {{{map::LaneKind::kDriving, map::LaneDirection::kBoth, 6}}, 3};
  road.profile = {{0, 10, 0}, {240, 34, 0}};
  const Polyline whole = {{0, 64}, {100, 64}, {120, 64}, {160, 64}, {240, 64}};
  for (const int x : {0, 1}) {
    scene::Chunk& chunk = scene.chunks.emplace_back();
    chunk.tile = {x, 0};
    chunk.heights = {{x * 128.0 - 64, -64}, {64, 64}, 5, 5, std::vector<std::int32_t>(25, 0)};
    chunk.roads = {road};
    chunk.roads[0].axis =
        x == 0 ? Polyline(whole.begin(), whole.begin() + 4) : Polyline(whole.begin() + 1, whole.end());
    chunk.roads[0].start_along_m = x == 0 ? 0 : 100;
  }
  const Result<Layer> layer = layer_of(scene, "roads");
  ASSERT_TRUE(layer);
  ASSERT_EQ(layer->size(), 1u);
  const LayerFeature& feature = (*layer)[0];
  ASSERT_EQ(feature.parts.size(), 1u);
  const std::vector<Vec3> expected = {{0, 64, 10}, {100, 64, 20}, {120, 64, 22}, {160, 64, 26}, {240, 64, 34}};
  EXPECT_EQ(feature.parts[0][0], expected);
  // without the tile in the middle a road comes in two lines
  scene.chunks[1].roads[0].axis.erase(scene.chunks[1].roads[0].axis.begin(), scene.chunks[1].roads[0].axis.begin() + 2);
  scene.chunks[1].roads[0].start_along_m = 160;
  scene.chunks[0].roads[0].axis.resize(2);
  const std::string text = geojson_of(*layer_of(scene, "roads"), map::Plane({10, 48}), {});
  EXPECT_NE(text.find(R"("type":"MultiLineString","coordinates":[[[)"), std::string::npos) << text;
  EXPECT_NE(text.find(",10.00],["), std::string::npos) << text;
}

TEST(GeoJson, UnknownLayersAreErrors) {
  EXPECT_TRUE(to_string(layer_of(scene::Scene{}, "clouds").error()).starts_with("--layer: expected "));
}

}  // namespace
}  // namespace citykiln::commands
