#include "compiler/bake/cut_vertices.h"

#include <cmath>
#include <vector>

#include "compiler/geometry/snap.h"

namespace citykiln::bake {
namespace {

materials::Tint mixed_tint(materials::Tint a, materials::Tint b, double share) {
  materials::Tint tint{};
  for (std::size_t i = 0; i < tint.size(); ++i)
    tint[i] = static_cast<std::uint8_t>(std::floor(a[i] + (b[i] - a[i]) * share + 0.5));
  return tint;
}

}  // namespace

void add_vertex_between(materials::MaterialMesh& whole, std::uint32_t a, std::uint32_t b, double share) {
  Mesh& mesh = whole.mesh;
  mesh.positions.push_back(snapped(mesh.positions[a] + (mesh.positions[b] - mesh.positions[a]) * share));
  if (!mesh.normals.empty())
    mesh.normals.push_back(unit(mesh.normals[a] + (mesh.normals[b] - mesh.normals[a]) * share));
  if (!whole.uvs.empty()) whole.uvs.push_back(whole.uvs[a] + (whole.uvs[b] - whole.uvs[a]) * share);
  if (!whole.tints.empty()) whole.tints.push_back(mixed_tint(whole.tints[a], whole.tints[b], share));
}

void drop_unused_vertices(materials::MaterialMesh& whole) {
  constexpr std::uint32_t kUnused = ~0u;
  Mesh& mesh = whole.mesh;
  std::vector<std::uint32_t> numbers(mesh.positions.size(), kUnused);
  for (const Triangle& t : mesh.triangles)
    for (const std::uint32_t v : t) numbers[v] = 0;
  std::uint32_t next = 0;
  const auto keep = [&](auto& values, std::uint32_t from, std::uint32_t to) {
    if (!values.empty()) values[to] = values[from];
  };
  for (std::uint32_t v = 0; v < numbers.size(); ++v) {
    if (numbers[v] == kUnused) continue;
    keep(mesh.positions, v, next), keep(mesh.normals, v, next), keep(whole.uvs, v, next), keep(whole.tints, v, next);
    numbers[v] = next++;
  }
  mesh.positions.resize(next);
  if (!mesh.normals.empty()) mesh.normals.resize(next);
  if (!whole.uvs.empty()) whole.uvs.resize(next);
  if (!whole.tints.empty()) whole.tints.resize(next);
  for (Triangle& t : mesh.triangles)
    for (std::uint32_t& v : t) v = numbers[v];
}

}  // namespace citykiln::bake
