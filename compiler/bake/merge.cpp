#include "compiler/bake/merge.h"

#include <array>
#include <cassert>

namespace citykiln::bake {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;

Float3 single(Vec3 v) {
  // + 0.0 turns a negative zero, which a text form cannot tell, into a positive one
  return {static_cast<float>(v.x) + 0.0f, static_cast<float>(v.y) + 0.0f, static_cast<float>(v.z) + 0.0f};
}

Float2 single(Vec2 v) { return {static_cast<float>(v.x) + 0.0f, static_cast<float>(v.y) + 0.0f}; }

// The primitive's vertices that one position of the mesh, with its uv, has become: one a normal, linked.
struct Copies {
  const materials::DressedMesh& dressed;
  Primitive& primitive;
  Vec3 origin;
  std::uint32_t feature;
  std::uint32_t base = static_cast<std::uint32_t>(primitive.positions.size());
  std::vector<std::uint32_t> first = std::vector<std::uint32_t>(dressed.mesh.positions.size(), kNone);  // by position
  std::vector<std::uint32_t> next{};  // by vertex of the primitive, from `base` on

  std::uint32_t vertex(std::uint32_t position, Float3 normal) {
    for (std::uint32_t v = first[position]; v != kNone; v = next[v - base])
      if (primitive.normals[v] == normal) return v;
    const auto v = static_cast<std::uint32_t>(primitive.positions.size());
    primitive.positions.push_back(offset_from(origin, dressed.mesh.positions[position]));
    primitive.normals.push_back(normal);
    primitive.colours.push_back(dressed.tints.empty() ? dressed.tint : dressed.tints[position]);
    primitive.features.push_back(feature);
    if (!dressed.uvs.empty()) primitive.uvs.push_back(single(dressed.uvs[position]));
    next.push_back(first[position]);
    first[position] = v;
    return v;
  }
};

Vec3 normal_of(const Mesh& mesh, const Triangle& t) {
  return unit(cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]]));
}

}  // namespace

Float3 offset_from(Vec3 origin, Vec3 p) { return single(p - origin); }

void merge(Merged& merged, const materials::DressedMesh& dressed, Vec3 origin, std::uint32_t feature) {
  const Mesh& mesh = dressed.mesh;
  assert(dressed.uvs.empty() ? dressed.coloured == materials::Coloured::kByMaterial
                             : dressed.uvs.size() == mesh.positions.size());
  assert(dressed.tints.empty() || dressed.tints.size() == mesh.positions.size());
  const PrimitiveKey key{dressed.material, !dressed.uvs.empty(), dressed.coloured};
  Primitive& primitive = merged[key];
  primitive.material = key.material, primitive.coloured = key.coloured;
  Copies copies{dressed, primitive, origin, feature};
  for (const Triangle& t : mesh.triangles) {
    const Vec3 flat = normal_of(mesh, t);
    if (flat == Vec3{}) continue;
    std::array<std::uint32_t, 3> corners{};
    for (int i = 0; i < 3; ++i)
      corners[i] = copies.vertex(t[i], single(mesh.normals.empty() ? flat : mesh.normals[t[i]]));
    primitive.triangles.push_back(corners);
  }
}

std::vector<materials::Texture> textures_shown(std::span<const Primitive> primitives, double tolerance_m,
                                               std::uint64_t seed) {
  std::vector<materials::Material> shown;
  for (const Primitive& p : primitives)
    if (!p.uvs.empty() && p.coloured == materials::Coloured::kByMaterial) shown.push_back(p.material);
  return materials::textures_of(shown, tolerance_m, seed);
}

std::vector<Primitive> primitives_of(Merged&& merged) {
  std::vector<Primitive> primitives;
  for (auto& [key, primitive] : merged)
    if (!primitive.triangles.empty()) primitives.push_back(std::move(primitive));
  return primitives;
}

}  // namespace citykiln::bake
