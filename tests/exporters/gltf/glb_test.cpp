#include "exporters/gltf/glb.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "exporters/gltf/material_names.h"
#include "exporters/gltf/picture_formats.h"
#include "tests/exporters/made_tile.h"

namespace citykiln::exporters {
namespace {

using bake::BakedTile;
using Bytes = std::vector<std::byte>;

constexpr GlbOptions kExtension{.target = Target::kThree, .split = Split::kTile},
    kNodes{.target = Target::kGeneric, .split = Split::kTile};
constexpr GlbOptions kAll[] = {kExtension,
                               kNodes,
                               {.target = Target::kThree},
                               {.target = Target::kGeneric},
                               {.target = Target::kThree, .split = Split::kBuilding},
                               {.target = Target::kGeneric, .split = Split::kBuilding}};

scene::Header header() {
  scene::Header h;
  h.origin = {7.25, 43.5}, h.attributions = {"© OpenStreetMap contributors", "hills"};
  return h;
}
// With exact pictures, so that the tile can be read back.
Bytes encoded(const BakedTile& tile, GlbOptions options) {
  options.has_exact_pictures = true;
  return encode_glb(tile, header(), options);
}
Result<BakedTile> decoded(const Bytes& bytes) { return decode_glb(bytes, "tile.glb"); }
std::string refusal(const Result<BakedTile>& result) { return result ? "accepted" : to_string(result.error()); }

void put_number(Bytes& bytes, std::size_t at, std::size_t value) {
  for (std::size_t i = 0; i < 4; ++i) bytes[at + i] = static_cast<std::byte>(value >> 8 * i);
}
std::string json_of(const Bytes& bytes) {
  std::uint32_t size = 0;
  std::memcpy(&size, bytes.data() + 12, 4);
  return {reinterpret_cast<const char*>(bytes.data()) + 20, size};
}

// The file with another JSON chunk, padded, and lengths that fit.
Bytes with_json(const Bytes& bytes, std::string json) {
  const auto buffer = std::span(bytes).subspan(20 + json_of(bytes).size());
  json.resize((json.size() + 3) / 4 * 4, ' ');
  Bytes changed(20 + json.size() + buffer.size());
  std::copy_n(bytes.begin(), 20, changed.begin());
  std::memcpy(changed.data() + 20, json.data(), json.size());
  std::copy(buffer.begin(), buffer.end(), changed.end() - static_cast<std::ptrdiff_t>(buffer.size()));
  put_number(changed, 8, changed.size()), put_number(changed, 12, json.size());
  return changed;
}

// The error for a tile in whose JSON one text is replaced by another.
std::string refusal_with(const GlbOptions& options, const std::string& text, const std::string& other,
                         const BakedTile& tile = made_tile(1)) {
  const Bytes bytes = encoded(tile, options);
  std::string json = json_of(bytes);
  const auto at = json.find(text);
  EXPECT_NE(at, std::string::npos) << text << " in " << json;
  if (at == std::string::npos) return "";
  return refusal(decoded(with_json(bytes, json.replace(at, text.size(), other))));
}

TEST(Glb, ReadsBackWhatItWroteForEachTargetAndSplit) {
  for (std::uint32_t seed = 0; seed < 100; ++seed)
    for (const GlbOptions& options : kAll) {
      for (const BakedTile& tile :
           {made_tile(seed), made_marked_tile(seed), made_facade_tile(seed), made_textured_tile(seed)}) {
        const auto back = decoded(encoded(tile, options));
        ASSERT_TRUE(back) << refusal(back);
        ASSERT_EQ(*back, tile);
      }
    }
}

nlohmann::json gltf_of(const BakedTile& tile) { return nlohmann::json::parse(json_of(encoded(tile, kExtension))); }

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
  for (bake::FeatureAttributes& row : tile.attributes) row.name.clear(), row.tags.clear();
  auto gltf = nlohmann::json::parse(json_of(encoded(tile, kExtension)));
  EXPECT_EQ(gltf["extensions"]["EXT_structural_metadata"]["propertyTables"][0]["properties"].size(), 4u);
  EXPECT_TRUE(*decoded(encoded(tile, kExtension)) == tile);
  tile.attributes.clear();
  gltf = nlohmann::json::parse(json_of(encoded(tile, kExtension)));
  EXPECT_EQ(gltf["extensions"]["EXT_structural_metadata"]["propertyTables"][0]["properties"].size(), 2u);
  EXPECT_TRUE(*decoded(encoded(tile, kExtension)) == tile);
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

TEST(GlbMarkingAtlas, IsWrittenOnceForAllThatIsOnIt) {
  const auto gltf = gltf_of(made_marked_tile(1));
  EXPECT_EQ(gltf["images"].size(), 1u);
  EXPECT_EQ(gltf["textures"].size(), 1u);
  EXPECT_EQ(gltf["images"][0]["mimeType"], "image/png");
  EXPECT_EQ(gltf["samplers"],
            nlohmann::json::parse(R"([{"magFilter": 9729, "minFilter": 9987, "wrapS": 33071, "wrapT": 10497}])"));
}

TEST(GlbMarkingAtlas, MarkedMaterialsShowItWithTheirOwnColour) {
  const auto gltf = gltf_of(made_marked_tile(1));
  int marked = 0;
  for (const auto& material : gltf["materials"]) {
    const bool is_marked = (material["name"].get<std::string>().find("Marked_") != std::string::npos);
    const auto& colours = material["pbrMetallicRoughness"];
    EXPECT_EQ(colours.contains("baseColorTexture"), is_marked);
    if (!is_marked) continue;
    ++marked;
    EXPECT_EQ(colours.value("baseColorFactor", nlohmann::json({1, 1, 1, 1})), nlohmann::json({1, 1, 1, 1}));
  }
  EXPECT_EQ(marked, 3);
}

// The bytes of an accessor's buffer view as floats.
std::vector<float> floats_of(const Bytes& glb, const nlohmann::json& gltf, std::size_t accessor) {
  const auto& view = gltf["bufferViews"][gltf["accessors"][accessor]["bufferView"].get<std::size_t>()];
  const std::size_t start = 20 + json_of(glb).size() + 8 + view.value("byteOffset", std::size_t{0});
  std::vector<float> values(view["byteLength"].get<std::size_t>() / sizeof(float));
  std::memcpy(values.data(), glb.data() + start, values.size() * sizeof(float));
  return values;
}

TEST(Glb, TextureCoordinatesAreInUnitsOfTheImageWithoutATransform) {
  const BakedTile tile = made_facade_tile(1);
  const Bytes glb = encoded(tile, kNodes);
  const auto gltf = nlohmann::json::parse(json_of(glb));
  EXPECT_FALSE(gltf.contains("extensionsRequired"));
  EXPECT_EQ(json_of(glb).find("KHR_texture_transform"), std::string::npos);
  const auto atlas = std::ranges::find_if(
      tile.primitives, [](const bake::Primitive& p) { return p.colour_source == materials::ColourSource::kByAtlas; });
  ASSERT_NE(atlas, tile.primitives.end());
  const auto& primitive = gltf["meshes"][0]["primitives"][static_cast<std::size_t>(atlas - tile.primitives.begin())];
  const std::vector<float> uvs = floats_of(glb, gltf, primitive["attributes"]["TEXCOORD_0"].get<std::size_t>());
  ASSERT_EQ(uvs.size(), 2 * atlas->uvs.size());
  const materials::TextureImage& image = tile.facade_atlas.colour;
  for (std::size_t i = 0; i < atlas->uvs.size(); ++i) {
    EXPECT_FLOAT_EQ(uvs[2 * i], static_cast<float>(atlas->uvs[i][0] / (image.columns * image.texel_m)));
    EXPECT_FLOAT_EQ(uvs[2 * i + 1], static_cast<float>(atlas->uvs[i][1] / (image.rows * image.texel_m)));
  }
}

// The names of all nodes below the root, and of theirs.
std::vector<std::string> names_below(const nlohmann::json& gltf, std::size_t node) {
  std::vector<std::string> names;
  for (const auto& child : gltf["nodes"][node].value("children", nlohmann::json::array()))
    names.push_back(gltf["nodes"][child.get<std::size_t>()]["name"]);
  return names;
}

nlohmann::json gltf_of(const BakedTile& tile, const GlbOptions& options) {
  return nlohmann::json::parse(json_of(encoded(tile, options)));
}

TEST(GlbMaterials, HaveDifferentNamesAndThoseWithImagesOfTheFileTheNameOfItsTileAndTolerance) {
  const auto gltf = gltf_of(made_facade_tile(1));
  std::set<std::string> names;
  for (const auto& material : gltf["materials"]) EXPECT_TRUE(names.insert(material["name"]).second) << material["name"];
  EXPECT_TRUE(names.contains("PaintFacadeAtlas_-3_17_0.1m"));
  EXPECT_TRUE(names.contains("BroadLeafCutout_-3_17_0.1m"));
  EXPECT_TRUE(names.contains("BroadLeafCutout_-3_17_0.1m_2"));
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
  const auto gltf = gltf_of(tile, {.split = Split::kBuilding});
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

TEST(GlbMarkingAtlas, TilesWithoutOneDoNotMentionIt) {
  const std::string json = json_of(encoded(made_tile(1), kExtension));
  for (const char* word : {"TEXCOORD_0", "images", "textures", "samplers", "Marked"})
    EXPECT_EQ(json.find(word), std::string::npos) << word;
}

nlohmann::json material_called(const nlohmann::json& gltf, const std::string& name) {
  for (const auto& material : gltf["materials"])
    if (material["name"] == name || material["name"].get<std::string>().starts_with(name + "_")) return material;
  ADD_FAILURE() << "no material " << name;
  return {};
}

TEST(GlbFacadeAtlas, SayColourRoughnessAndMetalness) {
  const auto gltf = gltf_of(made_facade_tile(1));
  const auto pbr = material_called(gltf, "PaintFacadeAtlas")["pbrMetallicRoughness"];
  for (const char* factor : {"baseColorFactor", "roughnessFactor", "metallicFactor"})
    EXPECT_EQ(pbr.value(factor, nlohmann::json(1)).flatten().begin().value(), 1) << factor;
  const auto picture = [&](const char* place) {
    const auto texture = gltf["textures"][pbr[place]["index"].get<std::size_t>()];
    // what lies at the other end of an atlas has nothing to do with this one
    EXPECT_EQ(gltf["samplers"][texture["sampler"].get<std::size_t>()]["wrapT"], 33071);
    return gltf["images"][texture["source"].get<std::size_t>()]["name"].get<std::string>();
  };
  EXPECT_EQ(picture("baseColorTexture"), "facade_atlas");
  EXPECT_EQ(picture("metallicRoughnessTexture"), "facade_atlas_surface");
}

TEST(GlbFacadeAtlas, ShineByAPictureOfTheirOwn) {
  const auto lit = material_called(gltf_of(made_facade_tile(1)), "PaintFacadeAtlas");
  EXPECT_EQ(lit["emissiveFactor"], nlohmann::json({1.0, 1.0, 1.0}));
  EXPECT_TRUE(lit.contains("emissiveTexture"));
  const auto dark = material_called(gltf_of(made_facade_tile(2)), "PaintFacadeAtlas");
  EXPECT_FALSE(dark.contains("emissiveFactor") || dark.contains("emissiveTexture"));
}

TEST(GlbFacadeAtlas, LeanByAPictureOfTheirOwnWithTangents) {
  for (const auto& [seed, leans] : {std::pair{1u, true}, {2u, false}}) {
    const auto gltf = gltf_of(made_facade_tile(seed));
    EXPECT_EQ(material_called(gltf, "PaintFacadeAtlas").contains("normalTexture"), leans);
    EXPECT_FALSE(gltf["meshes"][0]["primitives"].empty());
    for (const auto& primitive : gltf["meshes"][0]["primitives"]) {
      if (gltf["materials"][primitive["material"].get<std::size_t>()]["name"] != "PaintFacadeAtlas_-3_17_0.1m")
        continue;
      EXPECT_EQ(primitive["attributes"].contains("TANGENT"), leans);
    }
  }
}

TEST(GlbMaterials, OfPlantsHaveTheLargestTintSoThatReadersWithoutVertexColoursShowIt) {
  BakedTile tile = made_facade_tile(1);
  auto& primitives = tile.instanced.front().primitives;
  bake::Primitive& leaves =
      *std::ranges::find(primitives, materials::ColourSource::kByCutout, &bake::Primitive::colour_source);
  for (materials::Tint& tint : leaves.colours) tint = {51, 102, 0, 255};
  leaves.colours.back() = {51, 51, 0, 255};
  const auto gltf = gltf_of(tile);
  int found = 0;
  for (const auto& material : gltf["materials"]) {
    if (material.value("extras", nlohmann::json::object()).value("tint", nlohmann::json()) !=
        nlohmann::json({51, 102, 0}))
      continue;
    EXPECT_EQ(material["pbrMetallicRoughness"]["baseColorFactor"], nlohmann::json({0.2, 0.4, 0.0, 1.0}));
    ++found;
  }
  EXPECT_EQ(found, 1);
  const auto back = decoded(encoded(tile, {}));
  ASSERT_TRUE(back);
  EXPECT_EQ(*back, tile);
}

TEST(GlbMaterials, ShineAsTheTableSays) {
  std::mt19937 dice(5);
  BakedTile tile = made_tile(1);
  tile.primitives.push_back(made_primitive(dice, materials::Material::kRoomWall, 9, 4));
  const auto gltf = gltf_of(tile);
  const auto own = emission_of(materials::Material::kRoomWall);
  EXPECT_EQ(material_called(gltf, "RoomWall")["emissiveFactor"].get<std::vector<float>>(),
            std::vector<float>(own.begin(), own.end()));
  EXPECT_FALSE(material_called(gltf, "Grass").contains("emissiveFactor"));
}

TEST(GlbFacadeAtlas, AreRefusedWhereOneOfTwoPicturesIsMissing) {
  const BakedTile tile = made_facade_tile(1);
  const auto refused = [&](const char* name, const char* other) { return refusal_with(kExtension, name, other, tile); };
  EXPECT_NE(refused("\"facade_atlas\"", "\"GrassColour\""), "accepted");
  EXPECT_NE(refused("\"facade_atlas_surface\"", "\"GrassColour\""), "accepted");
  EXPECT_NE(refused("\"facade_atlas_normal\"", "\"facade_atlas_mormal\""), "accepted");
}

TEST(GlbMarkingAtlas, MaterialsOnItHaveNamesOfTheirOwn) {
  std::set<std::string> names;
  for (int m = 0; m < static_cast<int>(materials::Material::kCount); ++m)
    for (const auto colour_source : {materials::ColourSource::kByMaterial, materials::ColourSource::kByMarkingAtlas,
                                     materials::ColourSource::kByAtlas})
      EXPECT_TRUE(
          names.insert(material_name({{}, static_cast<materials::Material>(m), true, colour_source}, {})).second);
}

// The attributes of the primitive of a material.
nlohmann::json attributes_of(const nlohmann::json& gltf, const std::string& name) {
  for (const auto& primitive : gltf["meshes"][0]["primitives"])
    if (gltf["materials"][primitive["material"].get<std::size_t>()]["name"] == name) return primitive["attributes"];
  ADD_FAILURE() << "no primitive of " << name;
  return {};
}

TEST(GlbTextures, RepeatBothWays) {
  const auto gltf = gltf_of(made_textured_tile(1));
  ASSERT_EQ(gltf["samplers"].size(), 2u);
  EXPECT_EQ(gltf["samplers"][1]["wrapS"], 10497);
  EXPECT_EQ(gltf["samplers"][1]["wrapT"], 10497);
  // the marking atlas, four colours, and normals of water, rock, masonry and bark
  EXPECT_EQ(gltf["images"].size(), 9u);
  EXPECT_EQ(gltf["images"][0]["name"], "marking_atlas");
  EXPECT_EQ(gltf["textures"][0]["sampler"], 0);
  for (std::size_t i = 1; i < 9; ++i) EXPECT_EQ(gltf["textures"][i]["sampler"], 1);
}

TEST(GlbTextures, ShowTheirPictureTimesTheFactor) {
  const BakedTile tile = made_textured_tile(1);
  const auto gltf = gltf_of(tile);
  ASSERT_FALSE(tile.textures.empty());
  for (const materials::Texture& texture : tile.textures) {
    const std::string name(values_of(texture.material).name);
    const auto material = material_called(gltf, name);
    const auto factor = colour_factor(texture);
    const auto tint = material.value("extras", nlohmann::json::object()).value("tint", nlohmann::json({255, 255, 255}));
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_DOUBLE_EQ(material["pbrMetallicRoughness"]["baseColorFactor"][c].get<double>(),
                       factor[c] * (tint[c].get<double>() / 255))
          << name;
    if (texture.colour.texels.empty()) continue;
    const auto shown = material["pbrMetallicRoughness"]["baseColorTexture"];
    const auto& image =
        gltf["images"][gltf["textures"][shown["index"].get<std::size_t>()]["source"].get<std::size_t>()];
    EXPECT_EQ(image["name"], name + "Colour");
  }
}

TEST(GlbTextures, OfPackedMeshesHaveUvsInStepsWhere16BitsHoldThem) {
  const BakedTile tile = made_textured_tile(1);
  const auto grass = std::ranges::find(tile.textures, materials::Material::kGrass, &materials::Texture::material);
  ASSERT_NE(grass, tile.textures.end());
  const auto gltf = gltf_of(tile, {Target::kThree, Split::kTile, Compression::kMeshopt});
  const auto scale_of = [&](const char* name) {
    const auto transform = material_called(gltf, name)["pbrMetallicRoughness"]["baseColorTexture"]["extensions"];
    return transform["KHR_texture_transform"]["scale"][0].get<double>();
  };
  const auto uvs = [&](const char* name) {
    return gltf["accessors"][attributes_of(gltf, name)["TEXCOORD_0"].get<std::size_t>()];
  };
  EXPECT_EQ(uvs("Grass")["componentType"], 5123);
  EXPECT_EQ(scale_of("Grass"), uvs("Grass")["extras"]["step_m"].get<double>() / side_m(*grass));
}

TEST(GlbTextures, NormalsComeWithTangents) {
  const auto gltf = gltf_of(made_textured_tile(1));
  for (const char* name : {"Water", "Rock", "Stone"}) {
    EXPECT_TRUE(material_called(gltf, name).contains("normalTexture")) << name;
    EXPECT_TRUE(attributes_of(gltf, name).contains("TANGENT")) << name;
  }
  EXPECT_FALSE(attributes_of(gltf, "Grass").contains("TANGENT"));
}

TEST(GlbTextures, WhatHasNoPlacesOnThemKeepsItsColour) {
  const auto gltf = gltf_of(made_textured_tile(1));
  const auto plain = material_called(gltf, "StoneUntextured")["pbrMetallicRoughness"];
  EXPECT_FALSE(plain.contains("baseColorTexture"));
  EXPECT_EQ(plain["baseColorFactor"][0].get<float>(), values_of(materials::Material::kStone).base_colour[0]);
}

TEST(GlbTextures, AreInTheFormatsThatTheTargetReads) {
  const BakedTile tile = made_textured_tile(1);
  const auto types_for = [&](Target target) {
    const Bytes bytes = encode_glb(tile, header(), {.target = target});
    std::set<std::string> types;
    const auto gltf = nlohmann::json::parse(json_of(bytes));
    for (const auto& image : gltf.at("images")) types.insert(image.at("mimeType"));
    const auto back = decode_glb(bytes, "");
    EXPECT_TRUE(back && back->textures.size() == tile.textures.size());
    return types;
  };
  EXPECT_EQ(types_for(Target::kGeneric), (std::set<std::string>{"image/jpeg", "image/png"}));
  EXPECT_EQ(types_for(Target::kThree), (std::set<std::string>{"image/webp"}));
}

// The byte budget of a tile holds the textures of all materials together, all kinds of bark included.
TEST(GlbTextures, OfAllMaterialsFitTheBudget) {
  std::vector<materials::Material> all;
  for (int m = 0; m < static_cast<int>(materials::Material::kCount); ++m)
    all.push_back(static_cast<materials::Material>(m));
  const auto bytes_at = [&](double tolerance_m, PictureFormats formats) {
    std::size_t bytes = 0;
    for (const materials::Texture& texture : materials::textures_of(all, tolerance_m, 0)) {
      const auto add = [&](const materials::TextureImage& image, PictureContent content) {
        if (!image.texels.empty()) bytes += encode_picture(image, {}, content, formats).bytes.size();
      };
      add(texture.colour, PictureContent::kColour), add(texture.normal, PictureContent::kExact);
    }
    return bytes;
  };
  EXPECT_LE(bytes_at(0.1, PictureFormats::kPngAndJpeg), 850'000u);
  EXPECT_LE(bytes_at(0.1, PictureFormats::kWebp), 650'000u);
  EXPECT_LE(bytes_at(0.02, PictureFormats::kPngAndJpeg), 1'100'000u);
  EXPECT_EQ(bytes_at(0.5, PictureFormats::kPngAndJpeg), 0u);
}

TEST(Glb, BothWaysOfInstancingAreOneTile) {
  const auto with_extension = decoded(encoded(made_tile(1), kExtension)),
             with_nodes = decoded(encoded(made_tile(1), kNodes));
  ASSERT_TRUE(with_extension && with_nodes);
  EXPECT_EQ(*with_extension, *with_nodes);
}

TEST(Glb, SameTileSameBytes) {
  for (const GlbOptions& options : kAll) EXPECT_EQ(encoded(made_tile(1), options), encoded(made_tile(1), options));
}

TEST(Glb, TheOriginIsNotRoundedToSinglePrecision) {
  BakedTile tile = made_tile(1);
  tile.origin = {16777217, -16777219, 4097};
  const auto back = decoded(encoded(tile, kExtension));
  ASSERT_TRUE(back) << refusal(back);
  EXPECT_EQ(back->origin, tile.origin);
}

TEST(Glb, TellsForWhichEyeItWasMade) {
  BakedTile tile = made_tile(1);
  tile.viewpoint = bake::Viewpoint{{0.1, -16777219.25, 4097}, 869.1171875, 0.96};
  const auto back = decoded(encoded(tile, kExtension));
  ASSERT_TRUE(back) << refusal(back);
  EXPECT_EQ(back->viewpoint, tile.viewpoint);
}

TEST(Glb, MoreCornersThan16BitsCount) {
  std::mt19937 dice(1);
  BakedTile tile = made_tile(1);
  for (const std::uint32_t corners : {65533u, 65534u, 65535u, 65538u}) {
    tile.primitives = {made_primitive(dice, materials::Material::kRock, corners, 4)};
    const auto back = decoded(encoded(tile, kExtension));
    ASSERT_TRUE(back) << refusal(back);
    EXPECT_EQ(*back, tile) << corners;
  }
}

TEST(Glb, ATileWithoutGroundOrInstancesIsWhole) {
  BakedTile bare = made_tile(1), trees = made_tile(1);
  bare.instanced.clear(), trees.primitives.clear();
  for (const BakedTile& tile : {bare, trees}) {
    const auto back = decoded(encoded(tile, kNodes));
    ASSERT_TRUE(back) << refusal(back);
    EXPECT_EQ(*back, tile);
  }
}

TEST(GlbDamage, EveryTruncationIsRefused) {
  for (const BakedTile& tile : {made_tile(2), made_marked_tile(2)}) {
    const Bytes bytes = encoded(tile, kExtension);
    ASSERT_FALSE(bytes.empty());
    for (std::size_t size = 0; size < bytes.size(); ++size)
      ASSERT_FALSE(decoded(Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)))) << size;
  }
}

// Tiles have no checksum, so a changed byte may make another tile: one that can be written and read.
TEST(GlbDamage, AChangedByteIsRefusedOrMakesAnotherTile) {
  std::mt19937 dice(4);
  for (const GlbOptions& options : {kExtension, GlbOptions{}}) {
    const Bytes bytes = encoded(options.target == Target::kGeneric ? made_tile(3) : made_marked_tile(3), options);
    ASSERT_FALSE(bytes.empty());
    for (std::size_t at = 0; at < bytes.size(); at += 1 + dice() % 5) {
      Bytes changed = bytes;
      changed[at] ^= static_cast<std::byte>(1 + dice() % 255);
      const auto tile = decoded(changed);
      if (!tile) continue;
      for (const bake::Primitive& p : tile->primitives)
        for (const auto& triangle : p.triangles)
          for (const auto corner : triangle) ASSERT_LT(corner, p.positions.size()) << "byte " << at;
      const auto again = decoded(encoded(*tile, kExtension));
      ASSERT_TRUE(again) << "byte " << at << ": " << refusal(again);
      ASSERT_EQ(without_uvs(*again), without_uvs(*tile)) << "byte " << at;
    }
  }
}

TEST(GlbDamage, ABufferLongerThanTheFileIsRefused) {
  Bytes bytes = encoded(made_tile(1), kExtension);
  const std::size_t at = 20 + json_of(bytes).size();
  put_number(bytes, at, bytes.size() - at - 4);
  EXPECT_EQ(refusal(decoded(bytes)), "tile.glb: expected two chunks, JSON and its buffer, that fill the file");
}

TEST(GlbDamage, JsonNestedWithoutEndIsRefused) {
  const Bytes bytes = encoded(made_tile(1), kExtension);
  const std::string deep = std::string(500000, '['), end(500000, ']');
  EXPECT_EQ(refusal(decoded(with_json(bytes, "{\"asset\":{\"version\":\"2.0\"},\"extras\":" + deep + end + "}"))),
            "tile.glb: expected JSON that is not nested deeper than glTF ever is");
  const std::string text = R"({"asset":{"version":"2.0"},"extras":"\")" + deep + "\"}";
  EXPECT_EQ(refusal(decoded(with_json(bytes, text))), "tile.glb: expected a node for the tile, and one buffer");
}

TEST(GlbDamage, OtherFilesAreNotOpened) {
  const std::string json = R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":4,"uri":"/etc/hostname"}]})";
  EXPECT_EQ(refusal(decoded(with_json(encoded(made_tile(1), kExtension), json))),
            "tile.glb: expected a buffer inside the file");
}

TEST(GlbDamage, ANodeWithoutMeshIsRefused) {
  const std::string expected = "tile.glb: expected each mesh in nodes that follow each other, in order";
  EXPECT_EQ(refusal_with(kNodes, "\"mesh\":1", "\"mess\":1"), expected);
  EXPECT_EQ(refusal_with(kNodes, "\"mesh\":1", "\"mesh\":0"), expected);
  EXPECT_EQ(refusal_with(kExtension, "\"mesh\":2", "\"mesh\":1"), expected);
}

TEST(GlbDamage, NumbersBeyondTheirTypeAreRefused) {
  EXPECT_EQ(refusal_with(kExtension, "\"tile\":[-3", "\"tile\":[-3e30"), "tile.glb: expected a whole number");
  EXPECT_EQ(refusal_with(kNodes, "\"translation\":[0.25", "\"translation\":[1e300"),
            "tile.glb: expected places in single precision");
}

std::string marked_refusal_with(const std::string& text, const std::string& other) {
  return refusal_with(kExtension, text, other, made_marked_tile(1));
}

std::string images_of(const BakedTile& tile) { return gltf_of(tile)["images"].dump(); }

TEST(GlbMarkingAtlasDamage, AMissingImageIsRefused) {
  const std::string expected = "tile.glb: expected an image, and uvs, for primitives that an image colours";
  EXPECT_EQ(marked_refusal_with("\"images\"", "\"imagos\""), expected);
  EXPECT_EQ(marked_refusal_with("\"name\":\"Grass\"", "\"name\":\"GrassMarked\""), expected);
}

TEST(GlbMarkingAtlasDamage, PlacesForOtherCornersAreRefused) {
  bake::BakedTile tile = made_marked_tile(1);
  tile.primitives.back().uvs.pop_back();
  EXPECT_EQ(refusal(decoded(encoded(tile, kExtension))), "tile.glb: expected as many values in each attribute");
}

TEST(GlbMarkingAtlasDamage, PlacesThatAreNotFiniteAreRefused) {
  for (const float bad : {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
    bake::BakedTile tile = made_marked_tile(1);
    tile.primitives.back().uvs.back()[1] = bad;
    EXPECT_EQ(refusal(decoded(encoded(tile, kExtension))), "tile.glb: expected finite numbers");
  }
}

TEST(GlbMarkingAtlasDamage, ASecondMarkingAtlasIsRefused) {
  const std::string images = images_of(made_marked_tile(1)), one = images.substr(1, images.size() - 2);
  EXPECT_EQ(marked_refusal_with(images, "[" + one + "," + one + "]"),
            "tile.glb: expected images named after materials, and one marking atlas at most");
}

std::string textured_refusal_with(const std::string& text, const std::string& other) {
  return refusal_with(kExtension, text, other, made_textured_tile(1));
}

TEST(GlbTextureDamage, PicturesOfNoMaterialTwiceOrOutOfOrderAreRefused) {
  const std::string named = "tile.glb: expected images named after materials, and one marking atlas at most",
                    once = "tile.glb: expected each material's pictures once, in order";
  EXPECT_EQ(textured_refusal_with("\"GrassColour\"", "\"GrossColour\""), named);
  EXPECT_EQ(textured_refusal_with("\"GrassColour\"", "\"Grass\""), named);
  EXPECT_EQ(textured_refusal_with("\"RockColour\"", "\"RockNormal\""), once);
  EXPECT_EQ(textured_refusal_with("\"WaterNormal\"", "\"GrassColour\""), once);
  EXPECT_EQ(textured_refusal_with("\"GrassColour\"", "\"StoneColour\""), once);
}

TEST(GlbTextureDamage, AChangedByteOfTheJsonIsRefusedOrMakesAnotherTile) {
  std::mt19937 dice(5);
  const Bytes bytes = encoded(made_textured_tile(3), kExtension);
  const std::size_t end = 20 + json_of(bytes).size();
  ASSERT_GT(end, 0u);
  for (std::size_t at = 0; at < end; at += 1 + dice() % 5) {
    Bytes changed = bytes;
    changed[at] ^= static_cast<std::byte>(1 + dice() % 255);
    const auto tile = decoded(changed);
    if (!tile) continue;
    const auto again = decoded(encoded(*tile, kExtension));
    ASSERT_TRUE(again) << "byte " << at << ": " << refusal(again);
    ASSERT_EQ(without_uvs(*again), without_uvs(*tile)) << "byte " << at;
  }
}

TEST(GlbMarkingAtlasDamage, TexelsWithoutASizeAreRefused) {
  EXPECT_EQ(marked_refusal_with("\"texel_m\"", "\"texel_n\""),
            "tile.glb: expected the extras and extensions that citykiln writes");
  for (const char* bad : {"-0.", "0,\"other\":0."})
    EXPECT_EQ(marked_refusal_with("\"texel_m\":0.", std::string("\"texel_m\":") + bad),
              "tile.glb: expected texels with a size");
}

TEST(GlbMarkingAtlasDamage, APictureThatIsNoneIsRefused) {
  Bytes bytes = encoded(made_marked_tile(1), kExtension);
  const std::string signature = "\x89PNG", header = "IHDR";
  const auto find = [&](const std::string& word) {
    return std::search(bytes.begin(), bytes.end(), word.begin(), word.end(),
                       [](std::byte b, char c) { return b == static_cast<std::byte>(c); });
  };
  for (const std::string& word : {header, signature}) {
    const auto at = find(word);
    ASSERT_NE(at, bytes.end());
    *at ^= std::byte{1};
    EXPECT_EQ(refusal(decoded(bytes)).substr(0, 52), "tile.glb: expected a picture: expected a PNG picture");
  }
}

TEST(GlbMarkingAtlasDamage, APictureOutsideTheBufferIsRefused) {
  const std::string expected = "tile.glb: expected images inside the buffer, as citykiln writes them";
  const auto gltf = gltf_of(made_marked_tile(1));
  const auto view = gltf["images"][0]["bufferView"].get<std::size_t>();
  const std::string offset = "\"byteOffset\":" + gltf["bufferViews"][view]["byteOffset"].dump();
  for (const char* bad : {"\"byteOffset\":99999999", "\"byteOffset\":18446744073709551615", "\"byteOffset\":-1"})
    EXPECT_EQ(marked_refusal_with(offset, bad), expected) << bad;
  const std::string number = "\"bufferView\":" + std::to_string(view) + ",\"extras\"";
  for (const char* bad : {"\"bufferView\":9999,\"extras\"", "\"bufferView\":-1,\"extras\"", "\"extras\""})
    EXPECT_EQ(marked_refusal_with(number, bad), expected) << bad;
  EXPECT_EQ(marked_refusal_with("\"buffers\":[{", "\"buffers\":[{\"uri\":\"x\","),
            "tile.glb: expected a buffer inside the file");
  EXPECT_EQ(marked_refusal_with("\"buffers\":[{", "\"buffers\":[{},{"), expected);
}

TEST(GlbDamage, ABufferViewReadTwiceIsRefused) {
  EXPECT_EQ(refusal_with(kExtension, "\"bufferView\":0", "\"bufferView\":5"),
            "tile.glb: expected each byte of the buffer to be used once");
}

}  // namespace
}  // namespace citykiln::exporters
