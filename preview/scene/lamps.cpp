#include "preview/scene/lamps.h"

#include <algorithm>
#include <cmath>

#include "compiler/bake/place_lamps.h"
#include "compiler/contract/system/for_each_slot.h"

namespace citykiln::preview {
namespace {

StreetLamp lamp_at(const Placement& placement, props::LampKind kind, const props::Luminaire& light) {
  return {props::glass_of(placement, kind), static_cast<float>(placement.scale), light};
}

// The height of an instanced mesh that stands on z = 0.
double height_m_of(const bake::InstancedMesh& mesh) {
  float top_m = 0;
  for (const bake::Primitive& primitive : mesh.primitives)
    for (const bake::Float3& p : primitive.positions) top_m = std::max(top_m, p[2]);
  return top_m;
}

void add_instances(std::vector<StreetLamp>& lamps, Vec3 origin, const bake::InstancedMesh& mesh, props::LampKind kind) {
  const double mesh_m = height_m_of(mesh);
  for (std::size_t i = 0; i < mesh.translations.size(); ++i) {
    // lamps are turned about z alone
    const double sine = mesh.rotations[i][2], cosine = mesh.rotations[i][3];
    const Vec2 towards = unit(Vec2{cosine * cosine - sine * sine, 2 * sine * cosine});
    const double height_m = mesh_m * mesh.scales[i];
    const Placement placement{.at = origin + bake::widened(mesh.translations[i]),
                              .cos_yaw = towards.x,
                              .sin_yaw = towards.y,
                              .scale = height_m,
                              .feature = {}};
    lamps.push_back(lamp_at(placement, kind, props::luminaire_of(kind, height_m)));
  }
}

}  // namespace

std::vector<StreetLamp> lamps_of(const scene::Scene& scene, int threads) {
  const auto by_chunk = for_each_slot<std::vector<bake::PlacedLamp>>(
      scene.chunks.size(), threads, [&](std::size_t i) { return bake::lamps_of(scene.header, scene.chunks[i]); });
  std::vector<StreetLamp> lamps;
  for (const std::vector<bake::PlacedLamp>& placed : by_chunk)
    for (const bake::PlacedLamp& lamp : placed) lamps.push_back(lamp_at(lamp.placement, lamp.kind, lamp.light));
  return lamps;
}

std::vector<StreetLamp> lamps_of(std::span<const bake::BakedTile> tiles) {
  std::vector<StreetLamp> lamps;
  for (const bake::BakedTile& tile : tiles)
    for (const bake::InstancedMesh& mesh : tile.instanced)
      if (const auto kind = props::lamp_named(mesh.name)) add_instances(lamps, tile.origin, mesh, *kind);
  return lamps;
}

std::vector<sky::GroundLight> ground_lights(std::span<const StreetLamp> lamps, Vec3 eye) {
  std::vector<sky::GroundLight> lights;
  for (const StreetLamp& lamp : lamps)
    lights.push_back({in_plan(lamp.at) - in_plan(eye), lamp.light.lumen, lamp.light.temperature_k});
  return lights;
}

}  // namespace citykiln::preview
