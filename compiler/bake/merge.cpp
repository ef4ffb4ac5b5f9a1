#include "compiler/bake/merge.h"

#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <set>

namespace citykiln::bake {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;

Float3 single(Vec3 v) {
  // + 0.0 turns a negative zero, which text forms cannot represent, into a positive one
  return {static_cast<float>(v.x) + 0.0f, static_cast<float>(v.y) + 0.0f, static_cast<float>(v.z) + 0.0f};
}

Float2 single(Vec2 v) { return {static_cast<float>(v.x) + 0.0f, static_cast<float>(v.y) + 0.0f}; }

// A hash of a position, well mixed in its low bits.
std::size_t hash_of(const Float3& p) {
  std::uint64_t h = 0;
  for (const float c : p) h = (h ^ std::bit_cast<std::uint32_t>(c)) * 0x9e3779b97f4a7c15ull;
  return static_cast<std::size_t>(h >> 32 ^ h);
}

// True if two normals differ by less than a tenth of a degree, as those of triangles in one plane do.
bool are_alike(const Float3& a, const Float3& b) {
  constexpr float kMostDifference = 0x1p-10f;
  for (std::size_t c = 0; c < 3; ++c)
    if (std::abs(a[c] - b[c]) > kMostDifference) return false;
  return true;
}

// Finds the vertices that one mesh has added to a primitive, so that equal ones are shared.
struct Vertices {
  const materials::MaterialMesh& source;
  Primitive& primitive;
  Vec3 origin;
  std::uint32_t feature;
  std::uint32_t base = static_cast<std::uint32_t>(primitive.positions.size());
  // linked lists of vertices with one hash
  std::vector<std::uint32_t> first = std::vector<std::uint32_t>(std::bit_ceil(source.mesh.positions.size()), kNone);
  std::vector<std::uint32_t> next{};  // by vertex of the primitive - base

  bool is(std::uint32_t v, const Float3& p, const Float3& normal, materials::Tint tint, const Float2* uv) const {
    return primitive.positions[v] == p && are_alike(primitive.normals[v], normal) && primitive.colours[v] == tint &&
           (uv == nullptr || primitive.uvs[v] == *uv);
  }

  std::uint32_t vertex(std::uint32_t position, const Float3& normal) {
    const Float3 p = offset_from(origin, source.mesh.positions[position]);
    const materials::Tint tint = source.tints.empty() ? source.tint : source.tints[position];
    const Float2 uv = source.uvs.empty() ? Float2{} : single(source.uvs[position]);
    const Float2* const shown = source.uvs.empty() ? nullptr : &uv;
    std::uint32_t& head = first[hash_of(p) & (first.size() - 1)];
    for (std::uint32_t v = head; v != kNone; v = next[v - base])
      if (is(v, p, normal, tint, shown)) return v;
    primitive.positions.push_back(p);
    primitive.normals.push_back(normal);
    primitive.colours.push_back(tint);
    primitive.features.push_back(feature);
    if (shown != nullptr) primitive.uvs.push_back(uv);
    next.push_back(head);
    return head = static_cast<std::uint32_t>(primitive.positions.size() - 1);
  }

  // Removes the last vertices, so that so many remain.
  void shrink_to(std::size_t count) {
    while (primitive.positions.size() > count) {
      first[hash_of(primitive.positions.back()) & (first.size() - 1)] = next.back();
      primitive.positions.pop_back(), primitive.normals.pop_back(), primitive.colours.pop_back();
      primitive.features.pop_back(), next.pop_back();
      if (!source.uvs.empty()) primitive.uvs.pop_back();
    }
  }
};

bool has_two_alike(const std::array<std::uint32_t, 3>& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

}  // namespace

Vec3 normal_of(const Mesh& mesh, const Triangle& t) {
  return unit(cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]]));
}

Float3 offset_from(Vec3 origin, Vec3 p) { return single(p - origin); }

void merge(PrimitiveMap& merged, const LayeredMesh& part, Vec3 origin, std::uint32_t feature) {
  const materials::MaterialMesh& source = part.mesh;
  const Mesh& mesh = source.mesh;
  assert(source.uvs.empty() ? source.colour_source == materials::ColourSource::kByMaterial
                            : source.uvs.size() == mesh.positions.size());
  assert(source.tints.empty() || source.tints.size() == mesh.positions.size());
  const PrimitiveKey key{part.layer, source.material, !source.uvs.empty(), source.colour_source};
  Primitive& primitive = merged[key];
  primitive.material = key.material, primitive.colour_source = key.colour_source, primitive.layer = key.layer;
  Vertices vertices{source, primitive, origin, feature};
  for (const Triangle& t : mesh.triangles) {
    const Vec3 flat = normal_of(mesh, t);
    if (flat == Vec3{}) continue;
    const std::size_t before = primitive.positions.size();
    std::array<std::uint32_t, 3> corners{};
    for (int i = 0; i < 3; ++i)
      corners[i] = vertices.vertex(t[i], single(mesh.normals.empty() ? flat : mesh.normals[t[i]]));
    if (has_two_alike(corners))
      vertices.shrink_to(before);
    else
      primitive.triangles.push_back(corners);
  }
}

std::vector<materials::SharedTexture> textures_shown(const BakedTile& tile, double tolerance_m,
                                                     const materials::TextureCache& textures) {
  using materials::ColourSource;
  std::set<materials::Material> shown;
  const auto look_at = [&](const std::vector<Primitive>& primitives) {
    for (const Primitive& p : primitives) {
      // previews show the grain of what lies below markings
      const bool is_shown = p.colour_source == ColourSource::kByMaterial ||
                            (tile.viewpoint && p.colour_source == ColourSource::kByMarkingAtlas);
      if (!p.uvs.empty() && is_shown) shown.insert(p.material);
    }
  };
  look_at(tile.primitives);
  for (const InstancedMesh& instanced : tile.instanced) look_at(instanced.primitives);
  return textures.textures_of(std::vector(shown.begin(), shown.end()), tolerance_m);
}

std::vector<Primitive> primitives_of(PrimitiveMap&& merged) {
  std::vector<Primitive> primitives;
  for (auto& [key, primitive] : merged)
    if (!primitive.triangles.empty()) primitives.push_back(std::move(primitive));
  return primitives;
}

std::vector<Primitive> instanced_primitives(std::span<const materials::MaterialMesh> meshes, Layer layer) {
  PrimitiveMap merged;
  for (const materials::MaterialMesh& mesh : meshes) merge(merged, {mesh, layer}, {}, 0);
  std::vector<Primitive> primitives = primitives_of(std::move(merged));
  for (Primitive& primitive : primitives) primitive.features.clear();
  return primitives;
}

}  // namespace citykiln::bake
