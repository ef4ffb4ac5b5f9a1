#include "exporters/gltf/write/encode_clouds.h"

#include <gtest/gtest.h>

#include "tests/exporters/gltf/glb_json.h"

namespace citykiln::exporters {
namespace {

double error_m_of(sky::CloudKind kind) {
  const sky::CloudSurface triangle{.positions = {{0, 0, 0}, {9, 0, 0}, {0, 9, 0}},
                                   .normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}},
                                   .opacity = {1, 1, 1},
                                   .triangles = {{0, 1, 2}}};
  const std::vector<CloudMeshes> layers = {{.layer = {.kind = kind}, .clouds = 1, .parts = {triangle}}};
  const auto gltf = nlohmann::json::parse(json_of(encode_clouds(layers, {}, 40, 20)));
  return gltf.at("nodes").at(0).at("extras").at("error_m");
}

TEST(EncodeClouds, StatesAnErrorInMetresOfThePlane) {
  EXPECT_NEAR(error_m_of(sky::CloudKind::kCumulus), 69.28, 0.01);
  EXPECT_NEAR(error_m_of(sky::CloudKind::kCirrus), 8 * 69.28, 0.1) << "streaks are stretched 8 times";
}

}  // namespace
}  // namespace citykiln::exporters
