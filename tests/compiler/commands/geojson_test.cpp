#include "compiler/commands/geojson.h"

#include <gtest/gtest.h>

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
  EXPECT_NE(text.find(R"({"type":"LineString","coordinates":[[10.00000000,48.00000000],[10.00134)"), std::string::npos)
      << text;
  EXPECT_NE(text.find(R"("attribution":["© \"us\""])"), std::string::npos) << text;
}

TEST(GeoJson, RingsEndWhereTheyBegin) {
  const Result<Layer> layer = layer_of(one_of_each(), "buildings");
  ASSERT_TRUE(layer);
  const std::string text = geojson_of(*layer, map::Plane({10, 48}), {});
  EXPECT_NE(text.find(R"([[[10.00000000,48.00000000],)"), std::string::npos) << text;
  EXPECT_NE(text.find(R"([10.00000000,48.00000000]],[[)"), std::string::npos) << text;
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
  EXPECT_NE(text.find(R"("id":"w4","part":0,"class":"ResidentialRoad","layer":2,"passage":"bridge"})"),
            std::string::npos)
      << text;
}

TEST(GeoJson, UnknownLayersAreErrors) {
  EXPECT_TRUE(to_string(layer_of(scene::Scene{}, "clouds").error()).starts_with("--layer: expected "));
}

}  // namespace
}  // namespace citykiln::commands
