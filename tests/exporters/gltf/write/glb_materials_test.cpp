#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "compiler/materials/texture_cache.h"
#include "exporters/gltf/material_names.h"
#include "exporters/gltf/pictures/picture_formats.h"
#include "tests/exporters/gltf/glb_json.h"

namespace citykiln::exporters {
namespace {

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

TEST(GlbMaterials, HaveDifferentNamesAndThoseWithImagesOfTheFileTheNameOfItsTileAndTolerance) {
  const auto gltf = gltf_of(made_facade_tile(1));
  std::set<std::string> names;
  for (const auto& material : gltf["materials"]) EXPECT_TRUE(names.insert(material["name"]).second) << material["name"];
  EXPECT_TRUE(names.contains("PaintFacadeAtlas_-3_17_0.1m"));
  EXPECT_TRUE(names.contains("BroadLeafCutout_-3_17_0.1m"));
  EXPECT_TRUE(names.contains("BroadLeafCutout_-3_17_0.1m_2"));
}

TEST(GlbMarkingAtlas, TilesWithoutOneDoNotMentionIt) {
  const std::string json = json_of(encoded(made_tile(1), kExtension));
  for (const char* word : {"TEXCOORD_0", "images", "textures", "samplers", "Marked"})
    EXPECT_EQ(json.find(word), std::string::npos) << word;
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

// The primitives whose materials are of leaves.
std::vector<nlohmann::json> leaves_in(const nlohmann::json& gltf) {
  std::vector<nlohmann::json> leaves;
  for (const auto& mesh : gltf["meshes"])
    for (const auto& p : mesh["primitives"])
      if (gltf["materials"][p["material"].get<std::size_t>()]["name"].get<std::string>().find("Cutout") !=
          std::string::npos)
        leaves.push_back(p);
  return leaves;
}

TEST(GlbLeaves, HaveFacesForBothSidesOfTheSameVerticesWhereTheTargetCullsBacks) {
  const BakedTile tile = made_facade_tile(1);
  const auto culled = gltf_of(tile, {.target = Target::kGeneric}), shown = gltf_of(tile, {.target = Target::kBlender});
  const auto with_backs = leaves_in(culled), fronts = leaves_in(shown);
  ASSERT_GT(fronts.size(), 0u);
  ASSERT_EQ(with_backs.size(), fronts.size());
  const auto count = [](const auto& gltf, const nlohmann::json& accessor) {
    return gltf["accessors"][accessor.get<std::size_t>()]["count"].template get<std::size_t>();
  };
  for (std::size_t i = 0; i < fronts.size(); ++i) {
    EXPECT_EQ(count(culled, with_backs[i]["attributes"]["POSITION"]),
              count(shown, fronts[i]["attributes"]["POSITION"]));
    EXPECT_EQ(count(culled, with_backs[i]["indices"]), 2 * count(shown, fronts[i]["indices"]));
    EXPECT_FALSE(culled["materials"][with_backs[i]["material"].get<std::size_t>()].value("doubleSided", false));
    EXPECT_TRUE(shown["materials"][fronts[i]["material"].get<std::size_t>()].value("doubleSided", false));
  }
}

// Even those that are flat: a second primitive would be drawn apart.
TEST(GlbLeaves, AreOnePrimitiveWithNormals) {
  BakedTile tile = made_facade_tile(1);
  for (bake::InstancedMesh& tree : tile.instanced)
    for (bake::Primitive& p : tree.primitives)
      if (p.colour_source == materials::ColourSource::kByCutout) {
        const auto [a, b, c] = p.triangles.front();
        p.positions[a] = {0, 0, 1}, p.positions[b] = {4, 0, 1}, p.positions[c] = {0, 4, 1};
        for (const std::uint32_t v : {a, b, c}) p.normals[v] = {0, 0, 1};
        p.triangles = {{a, b, c}};
      }
  const auto gltf = gltf_of(tile, {.target = Target::kBlender});
  for (const auto& leaves : leaves_in(gltf)) EXPECT_TRUE(leaves["attributes"].contains("NORMAL"));
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

TEST(GlbTextures, RepeatBothWays) {
  const auto gltf = gltf_of(made_textured_tile(1));
  ASSERT_EQ(gltf["samplers"].size(), 2u);
  EXPECT_EQ(gltf["samplers"][1]["wrapS"], 10497);
  EXPECT_EQ(gltf["samplers"][1]["wrapT"], 10497);
  // the marking atlas, four colours, normals of all five, and the roughness of masonry
  EXPECT_EQ(gltf["images"].size(), 11u);
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
  const auto gltf = gltf_of(tile, {Target::kThree, NodeSplit::kTile, Compression::kMeshopt});
  const auto scale_of = [&](const char* name) {
    const auto transform = material_called(gltf, name)["pbrMetallicRoughness"]["baseColorTexture"]["extensions"];
    return transform["KHR_texture_transform"]["scale"][0].get<double>();
  };
  const auto uvs = [&](const char* name) {
    return gltf["accessors"][attributes_of(gltf, name)["TEXCOORD_0"].get<std::size_t>()];
  };
  EXPECT_EQ(uvs("Grass")["componentType"], 5123);
  EXPECT_EQ(scale_of("Grass"), uvs("Grass")["extras"]["step_m"].get<double>() / side_m(**grass));
}

TEST(GlbTextures, NormalsComeWithTangents) {
  const auto gltf = gltf_of(made_textured_tile(1));
  for (const char* name : {"Grass", "Water", "Rock", "Stone"}) {
    EXPECT_TRUE(material_called(gltf, name).contains("normalTexture")) << name;
    EXPECT_TRUE(attributes_of(gltf, name).contains("TANGENT")) << name;
  }
  EXPECT_FALSE(attributes_of(gltf, "StoneUntextured").contains("TANGENT"));
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

// All materials together, of which a tile shows a third: files that tiles share take less than 8 MB a run.
TEST(GlbTextures, OfAllMaterialsFitTheBudget) {
  std::vector<materials::Material> all;
  for (int m = 0; m < static_cast<int>(materials::Material::kCount); ++m)
    all.push_back(static_cast<materials::Material>(m));
  const auto bytes_at = [&](double tolerance_m, PictureFormats formats) {
    std::size_t bytes = 0;
    for (const materials::Texture& texture : materials::TextureCache(0).textures_of(all, tolerance_m)) {
      const auto add = [&](const materials::TextureImage& image, PictureContent content) {
        if (!image.texels.empty()) bytes += encode_picture(image, {}, content, formats).bytes.size();
      };
      add(texture.colour, PictureContent::kColour), add(texture.normal, PictureContent::kExact);
      add(texture.surface, PictureContent::kExact);
    }
    return bytes;
  };
  EXPECT_LE(bytes_at(0.1, PictureFormats::kPngAndJpeg), 2'100'000u);
  EXPECT_LE(bytes_at(0.1, PictureFormats::kWebp), 1'700'000u);
  EXPECT_LE(bytes_at(0.02, PictureFormats::kPngAndJpeg), 6'500'000u);
  EXPECT_EQ(bytes_at(0.5, PictureFormats::kPngAndJpeg), 0u);
}

}  // namespace
}  // namespace citykiln::exporters
