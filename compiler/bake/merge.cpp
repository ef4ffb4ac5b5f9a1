#include "compiler/bake/merge.h"

#include <array>

namespace citykiln::bake {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;

Float3 single(Vec3 v) {
  // + 0.0 turns a negative zero, which a text form cannot tell, into a positive one
  return {static_cast<float>(v.x) + 0.0f, static_cast<float>(v.y) + 0.0f, static_cast<float>(v.z) + 0.0f};
}

// The primitive's vertices that one position of the mesh has become: one a normal, linked.
struct Copies {
  Primitive& primitive;
  std::vector<std::uint32_t> first;  // by position of the mesh
  std::vector<std::uint32_t> next;   // by vertex of the primitive, from `base` on
  std::uint32_t base;

  Copies(Primitive& p, std::size_t positions)
      : primitive(p), first(positions, kNone), base(static_cast<std::uint32_t>(p.positions.size())) {}

  std::uint32_t vertex(std::uint32_t position, Float3 at, Float3 normal, materials::Tint tint, std::uint32_t feature) {
    for (std::uint32_t v = first[position]; v != kNone; v = next[v - base])
      if (primitive.normals[v] == normal) return v;
    const auto v = static_cast<std::uint32_t>(primitive.positions.size());
    primitive.positions.push_back(at);
    primitive.normals.push_back(normal);
    primitive.colours.push_back(tint);
    primitive.features.push_back(feature);
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
  Primitive& primitive = merged[dressed.material];
  primitive.material = dressed.material;
  const Mesh& mesh = dressed.mesh;
  Copies copies(primitive, mesh.positions.size());
  for (const Triangle& t : mesh.triangles) {
    const Vec3 flat = normal_of(mesh, t);
    if (flat == Vec3{}) continue;
    std::array<std::uint32_t, 3> corners{};
    for (int i = 0; i < 3; ++i) {
      const Float3 normal = single(mesh.normals.empty() ? flat : mesh.normals[t[i]]);
      corners[i] = copies.vertex(t[i], offset_from(origin, mesh.positions[t[i]]), normal, dressed.tint, feature);
    }
    primitive.triangles.push_back(corners);
  }
}

std::vector<Primitive> primitives_of(Merged&& merged) {
  std::vector<Primitive> primitives;
  for (auto& [material, primitive] : merged)
    if (!primitive.triangles.empty()) primitives.push_back(std::move(primitive));
  return primitives;
}

}  // namespace citykiln::bake
