#include "exporters/gltf/write/encode_lights.h"

#include <cmath>
#include <numbers>

#include "tests/exporters/gltf/glb_json.h"

namespace citykiln::exporters {
namespace {

using bake::PlacedLamp;
using props::LampKind;

// Near the origin of the made tile.
std::vector<PlacedLamp> made_lamps(Vec3 origin) {
  const auto lamp = [&](double x, LampKind kind, double height_m, std::int64_t id, const map::LampTags& tags = {}) {
    const Placement placement{.at = origin + Vec3{x, 20, 3}, .scale = height_m, .feature = {OsmType::kNode, id}};
    return PlacedLamp{placement, kind, props::luminaire_of(kind, height_m, tags)};
  };
  return {lamp(5, LampKind::kPostTop, 4, 1), lamp(25, LampKind::kArm, 10, 2), lamp(45, LampKind::kArm, 10, 3),
          lamp(65, LampKind::kArm, 10, 4, {.type = map::LampType::kHighPressureSodium})};
}

GlbOptions with_lights(GlbOptions options, const std::vector<PlacedLamp>& lamps) {
  options.lights = lamps;
  return options;
}

const nlohmann::json& light_group(const nlohmann::json& gltf) {
  return gltf["nodes"][gltf["nodes"][0]["children"].back().get<std::size_t>()];
}

TEST(GlbLights, AreOneNodeEachBelowOneGroupAndShareTheirLight) {
  const BakedTile tile = made_tile(1);
  const auto lamps = made_lamps(tile.origin);
  for (const GlbOptions& options : kAll) {
    const auto gltf = gltf_of(tile, with_lights(options, lamps));
    const auto& group = light_group(gltf);
    EXPECT_EQ(group["name"], "lights");
    ASSERT_EQ(group["children"].size(), lamps.size());
    EXPECT_EQ(gltf["extensions"]["KHR_lights_punctual"]["lights"].size(), 3u);
    const auto& used = gltf["extensionsUsed"];
    EXPECT_EQ(std::ranges::count(used, "KHR_lights_punctual"), 1);
    const std::string required = gltf.value("extensionsRequired", nlohmann::json::array()).dump();
    EXPECT_EQ(required.find("lights"), std::string::npos);
    for (std::size_t i = 0; i < lamps.size(); ++i) {
      const auto& node = gltf["nodes"][group["children"][i].get<std::size_t>()];
      const Vec3 glass = props::glass_of(lamps[i].placement, lamps[i].kind) - tile.origin;
      const auto& at = node["translation"];
      EXPECT_NEAR(at[0].get<double>(), glass.x, 1e-5);
      EXPECT_NEAR(at[1].get<double>(), glass.z, 1e-5);
      EXPECT_NEAR(at[2].get<double>(), -glass.y, 1e-5);
      EXPECT_EQ(node["extras"]["osm_id"], static_cast<double>(lamps[i].placement.feature.id));
    }
  }
}

double luminance_of(const nlohmann::json& light) {
  const auto& c = light["color"];
  return light["intensity"].get<double>() *
         (0.2126 * c[0].get<double>() + 0.7152 * c[1].get<double>() + 0.0722 * c[2].get<double>());
}

// The spot's intensity by the extension's formula, over all directions.
TEST(GlbLights, GiveTheLumenOfTheirLamp) {
  const BakedTile tile = made_tile(1);
  const auto lamps = made_lamps(tile.origin);
  const auto gltf = gltf_of(tile, with_lights(kNodes, lamps));
  const auto& lights = gltf["extensions"]["KHR_lights_punctual"]["lights"];
  EXPECT_EQ(lights[0]["type"], "point");
  EXPECT_NEAR(luminance_of(lights[0]) * 3 * std::numbers::pi, lamps[0].light.lumen, 1);
  for (const std::size_t i : {1, 2}) {
    EXPECT_EQ(lights[i]["type"], "spot");
    const double inner = std::cos(lights[i]["spot"].value("innerConeAngle", 0.0)),
                 outer = std::cos(lights[i]["spot"]["outerConeAngle"].get<double>());
    double sr = 0;
    for (double cosine = 0.0005; cosine < 1; cosine += 0.001) {
      const double share = std::clamp((cosine - outer) / (inner - outer), 0.0, 1.0);
      sr += 2 * std::numbers::pi * share * share * 0.001;
    }
    EXPECT_NEAR(luminance_of(lights[i]) * sr, 10000, 20);
    EXPECT_GT(lights[i]["range"].get<double>(), 50);
    for (const auto& component : lights[i]["color"]) EXPECT_TRUE(component >= 0 && component <= 1);
  }
  EXPECT_LT(lights[2]["color"][2].get<double>(), 0.5 * lights[1]["color"][2].get<double>());
}

TEST(GlbLights, DoNotChangeTheTileThatIsReadBack) {
  const BakedTile tile = made_tile(1);
  const auto lamps = made_lamps(tile.origin);
  for (const GlbOptions& options : kAll) {
    const Result<BakedTile> read = decoded(encoded(tile, with_lights(options, lamps)));
    ASSERT_TRUE(read) << refusal(read);
    EXPECT_TRUE(*read == tile);
  }
}

TEST(Brightest, AreInTheirOrderAndOfEqualOnesTheFirst) {
  const auto lamps = made_lamps({});
  const auto two = bake::brightest(lamps, 2);
  ASSERT_EQ(two.size(), 2u);
  EXPECT_EQ(two[0].placement.feature.id, 2);
  EXPECT_EQ(two[1].placement.feature.id, 3);
  EXPECT_EQ(bake::brightest(lamps, 9).size(), lamps.size());
  EXPECT_TRUE(bake::brightest(lamps, 0).empty());
}

}  // namespace
}  // namespace citykiln::exporters
