#include "preview/scene/lamps.h"

#include <algorithm>
#include <cmath>

#include "compiler/bake/place_lamps.h"
#include "compiler/contract/for_each_slot.h"

namespace citykiln::preview {
namespace {

// The middle of the glass of a lamp of 1 m (compiler/props/lamp_mesh.cpp): along its arm, and above the ground.
constexpr Vec2 kPostTopGlass_m{0, 0.93}, kArmGlass_m{0.172, 0.983};

StreetLamp lamp_at(Vec3 foot, double height_m, Vec2 towards, bool has_arm) {
  const Vec2 glass = (has_arm ? kArmGlass_m : kPostTopGlass_m) * height_m;
  const Vec2 head = in_plan(foot) + towards * glass.x;
  return {at_height(head, foot.z + glass.y), static_cast<float>(height_m), towards, has_arm};
}

// The height of an instanced mesh that stands on z = 0.
double height_m_of(const bake::InstancedMesh& mesh) {
  float top_m = 0;
  for (const bake::Primitive& primitive : mesh.primitives)
    for (const bake::Float3& p : primitive.positions) top_m = std::max(top_m, p[2]);
  return top_m;
}

void add_instances(std::vector<StreetLamp>& lamps, Vec3 origin, const bake::InstancedMesh& mesh, bool has_arm) {
  const double height_m = height_m_of(mesh);
  for (std::size_t i = 0; i < mesh.translations.size(); ++i) {
    // lamps are turned about z alone
    const double sine = mesh.rotations[i][2], cosine = mesh.rotations[i][3];
    const Vec2 towards = unit(Vec2{cosine * cosine - sine * sine, 2 * sine * cosine});
    lamps.push_back(lamp_at(origin + bake::widened(mesh.translations[i]), height_m * mesh.scales[i], towards, has_arm));
  }
}

}  // namespace

std::vector<StreetLamp> lamps_of(const scene::Scene& scene, int threads) {
  const auto by_chunk = for_each_slot<std::vector<bake::PlacedLamp>>(
      scene.chunks.size(), threads, [&](std::size_t i) { return bake::lamps_of(scene.header, scene.chunks[i]); });
  std::vector<StreetLamp> lamps;
  for (const std::vector<bake::PlacedLamp>& placed : by_chunk)
    for (const auto& [placement, kind] : placed)
      lamps.push_back(lamp_at(placement.at, placement.scale, Vec2{placement.cos_yaw, placement.sin_yaw},
                              kind == props::LampKind::kArm));
  return lamps;
}

std::vector<StreetLamp> lamps_of(std::span<const bake::BakedTile> tiles) {
  std::vector<StreetLamp> lamps;
  for (const bake::BakedTile& tile : tiles)
    for (const bake::InstancedMesh& mesh : tile.instanced)
      if (mesh.name == "PostTopLamp" || mesh.name == "ArmLamp")
        add_instances(lamps, tile.origin, mesh, mesh.name == "ArmLamp");
  return lamps;
}

}  // namespace citykiln::preview
