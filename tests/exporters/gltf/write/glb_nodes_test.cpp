#include <gtest/gtest.h>

#include <algorithm>

#include "tests/exporters/gltf/glb_json.h"

namespace citykiln::exporters {
namespace {

TEST(GlbPropertyTable, HasTheAttributesOfEachFeature) {
  const Bytes bytes = encoded(made_tile(1), kExtension);
  const auto gltf = nlohmann::json::parse(json_of(bytes));
  const auto& metadata = gltf["extensions"]["EXT_structural_metadata"];
  const auto& table = metadata["propertyTables"][0];
  EXPECT_EQ(table["count"], 4);
  const auto& properties = metadata["schema"]["classes"]["osm"]["properties"];
  ASSERT_EQ(properties.size(), 6u);
  for (const auto& [name, property] : properties.items()) EXPECT_TRUE(table["properties"].contains(name)) << name;
  EXPECT_EQ(metadata["schema"]["enums"]["class"]["values"],
            nlohmann::json::parse(R"([{"name":"none","value":0},{"name":"Apartments","value":1},
                                      {"name":"Park","value":2},{"name":"oak","value":3}])"));
  const auto& names = gltf["bufferViews"][table["properties"]["name"]["values"].get<std::size_t>()];
  const std::string buffer(reinterpret_cast<const char*>(bytes.data()) + 28 + json_of(bytes).size(),
                           bytes.size() - 28 - json_of(bytes).size());
  EXPECT_EQ(buffer.substr(names["byteOffset"].get<std::size_t>(), names["byteLength"].get<std::size_t>()),
            "Château «Ω»Parc");
}

TEST(GlbPropertyTable, LeavesOutColumnsWithoutValues) {
  BakedTile tile = made_tile(1);
  for (bake::FeatureAttributes& row : tile.attributes) row.name.clear(), row.tags = {};
  auto gltf = nlohmann::json::parse(json_of(encoded(tile, kExtension)));
  EXPECT_EQ(gltf["extensions"]["EXT_structural_metadata"]["propertyTables"][0]["properties"].size(), 4u);
  EXPECT_TRUE(*decoded(encoded(tile, kExtension)) == tile);
  tile.attributes.clear();
  gltf = nlohmann::json::parse(json_of(encoded(tile, kExtension)));
  EXPECT_EQ(gltf["extensions"]["EXT_structural_metadata"]["propertyTables"][0]["properties"].size(), 2u);
  EXPECT_TRUE(*decoded(encoded(tile, kExtension)) == tile);
}

TEST(GlbPropertyTable, MarksWhatIsAssumedAndNamesTheBits) {
  BakedTile tile = made_tile(1);
  const Bytes without = encoded(tile, kExtension);
  EXPECT_EQ(json_of(without).find("assumed"), std::string::npos);
  tile.attributes[2].assumed = bit_of(Assumption::kHeights) | bit_of(Assumption::kPavements);
  const Bytes bytes = encoded(tile, kExtension);
  const auto gltf = nlohmann::json::parse(json_of(bytes));
  const auto& property =
      gltf["extensions"]["EXT_structural_metadata"]["schema"]["classes"]["osm"]["properties"]["assumed"];
  EXPECT_EQ(property["componentType"], "UINT16");
  EXPECT_NE(property["description"].get<std::string>().find("1 pavements, 2 lamps, 4 heights"), std::string::npos);
  EXPECT_TRUE(*decoded(bytes) == tile);
  tile.attributes[2].assumed = kNoAssumptions;
  EXPECT_EQ(encoded(tile, kExtension), without);
}

TEST(GlbPropertyTable, NamesWhatIsAssumedInExtras) {
  BakedTile tile = made_tile(1);
  tile.attributes[1].assumed = bit_of(Assumption::kLamps) | bit_of(Assumption::kPavements);
  EXPECT_NE(json_of(encoded(tile, kNodes)).find(R"("assumed":["pavements","lamps"])"), std::string::npos);
}

TEST(GlbPropertyTable, IsAlsoInTheExtrasOfNodes) {
  const BakedTile tile = made_tile(1);
  const auto gltf = nlohmann::json::parse(json_of(encoded(tile, kNodes)));
  std::set<std::string> seen;
  for (const auto& node : gltf["nodes"])
    if (node.contains("extras") && node["extras"].contains("feature")) seen.insert(node["extras"].dump());
  ASSERT_GT(seen.size(), 1u);
  for (const std::string& extras : seen)
    EXPECT_TRUE(extras == R"({"feature":0})" ||
                extras == R"({"class":"oak","feature":1,"height_m":12.3,"osm_id":5,"osm_type":"node"})" ||
                extras == R"({"class":"Apartments","feature":2,"height_m":31.0,"name":"Château «Ω»","osm_id":-12,)"
                          R"("osm_type":"way","tags":{"building":"yes"}})" ||
                extras == R"({"class":"Park","feature":3,"name":"Parc","osm_id":9.007199254740992e+15,)"
                          R"("osm_type":"relation"})")
        << extras;
}

// The plants of a garden would repeat the tags of its house.
TEST(GlbNodes, OfInstancesHaveTheTagsOfTheirFeatureOnce) {
  BakedTile tile = made_tile(1);
  for (bake::InstancedMesh& mesh : tile.instanced) std::ranges::fill(mesh.features, 2u);
  const auto gltf = gltf_of(tile, kNodes);
  std::size_t nodes = 0, with_tags = 0;
  for (const auto& node : gltf["nodes"]) {
    if (node.value("extras", nlohmann::json::object()).value("feature", 0) != 2) continue;
    EXPECT_EQ(node["extras"]["osm_id"], -12);
    ++nodes, with_tags += node["extras"].contains("tags");
  }
  EXPECT_GT(nodes, 1u);
  EXPECT_EQ(with_tags, 1u);
}

TEST(GlbNodes, OfInstancesHaveNumbersOfAsFewDigitsAsAFloatNeeds) {
  BakedTile tile = made_tile(1);
  tile.instanced.front().scales.front() = 0.41066718f;
  const std::string json = json_of(encoded(tile, kNodes));
  EXPECT_NE(json.find("[0.41066718,0.41066718,0.41066718]"), std::string::npos);
}

TEST(GlbPropertyTableDamage, TextsOutsideTheirViewAndOtherEncodingsAreRefused) {
  for (const char* text : {R"("stringOffsetType":"UINT16")", R"("valueType":"UINT16")"})
    EXPECT_NE(json_of(encoded(made_tile(1), kExtension)).find(text), std::string::npos) << text;
  EXPECT_NE(refusal_with(kExtension, R"("stringOffsetType":"UINT16")", R"("stringOffsetType":"UINT32")"), "accepted");
  Bytes bytes = encoded(made_tile(1), kExtension);
  const std::string name = "Château";
  const auto at = std::search(bytes.begin(), bytes.end(), name.begin(), name.end(),
                              [](std::byte b, char c) { return b == static_cast<std::byte>(c); });
  ASSERT_NE(at, bytes.end());
  *(at + 3) = std::byte{0xff};
  EXPECT_EQ(refusal(decoded(bytes)), "tile.glb: expected texts in UTF-8");
}

TEST(GlbNodes, AreLayersWithTheirMeshes) {
  const BakedTile tile = made_facade_tile(1);
  const auto gltf = gltf_of(tile, {});
  EXPECT_EQ(names_below(gltf, 0), (std::vector<std::string>{"ground", "roads", "buildings", "plants"}));
  EXPECT_FALSE(gltf["nodes"][0].contains("mesh"));
  for (const auto& child : gltf["nodes"][0]["children"]) {
    const auto& node = gltf["nodes"][child.get<std::size_t>()];
    if (node["name"] == "plants") continue;
    EXPECT_EQ(gltf["meshes"][node["mesh"].get<std::size_t>()]["extras"]["layer"], node["name"]);
  }
}

TEST(GlbNodes, OfPlantsHoldANodePerPlantOrOnePerKind) {
  const BakedTile tile = made_tile(1);
  const auto plants_of = [&](Target target) {
    const auto gltf = gltf_of(tile, {.target = target});
    return names_below(gltf, gltf["nodes"][0]["children"].back().get<std::size_t>()).size();
  };
  EXPECT_EQ(plants_of(Target::kGeneric), 7u);
  EXPECT_EQ(plants_of(Target::kThree), 2u);
}

TEST(GlbNodes, OfBuildingsSayTheirOsmElement) {
  const BakedTile tile = made_facade_tile(1);
  const auto gltf = gltf_of(tile, {.split = NodeSplit::kBuilding});
  const auto& layer = gltf["nodes"][gltf["nodes"][0]["children"][2].get<std::size_t>()];
  ASSERT_EQ(layer["name"], "buildings");
  EXPECT_FALSE(layer.contains("mesh"));
  ASSERT_EQ(layer["children"].size(), 2u);
  const auto& building = gltf["nodes"][layer["children"][1].get<std::size_t>()];
  EXPECT_EQ(building["name"], "way_-12");
  EXPECT_EQ(building["extras"]["osm_type"], "way");
  EXPECT_EQ(building["extras"]["osm_id"], -12);
  // its plain walls and those on the facade atlas
  EXPECT_EQ(gltf["meshes"][building["mesh"].get<std::size_t>()]["primitives"].size(), 2u);
}

}  // namespace
}  // namespace citykiln::exporters
