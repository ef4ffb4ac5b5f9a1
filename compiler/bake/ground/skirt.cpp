#include "compiler/bake/ground/skirt.h"

#include <cassert>
#include <utility>
#include <vector>

#include "compiler/geometry/snap.h"

namespace citykiln::bake {
namespace {

bool is_in_border(const Box2& tile, Vec3 a, Vec3 b) {
  const bool is_vertical = a.x == b.x && a.y == b.y;
  if (is_vertical) return false;
  return (a.x == b.x && (a.x == tile.min.x || a.x == tile.max.x)) ||
         (a.y == b.y && (a.y == tile.min.y || a.y == tile.max.y));
}

// Edges of upward faces that are in a border, with the face to their left.
template <typename IsInBorder>
std::vector<std::pair<std::uint32_t, std::uint32_t>> edges_in_border(const Mesh& mesh, IsInBorder is_in) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const Triangle& t : mesh.triangles) {
    const Vec2 a = in_plan(mesh.positions[t[0]]);
    if (cross(in_plan(mesh.positions[t[1]]) - a, in_plan(mesh.positions[t[2]]) - a) <= 0) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = t[i], to = t[(i + 1) % 3];
      if (is_in(mesh.positions[from], mesh.positions[to])) edges.emplace_back(from, to);
    }
  }
  return edges;
}

// Adds a copy of a vertex, `depth_m` below it.
std::uint32_t add_lower(materials::MaterialMesh& surface, std::uint32_t vertex, double depth_m) {
  Mesh& mesh = surface.mesh;
  mesh.positions.push_back(mesh.positions[vertex] - Vec3{0, 0, depth_m});
  if (!mesh.normals.empty()) mesh.normals.push_back(mesh.normals[vertex]);
  if (!surface.tints.empty()) surface.tints.push_back(surface.tints[vertex]);
  if (!surface.uvs.empty()) surface.uvs.push_back(surface.uvs[vertex]);
  return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

template <typename IsInBorder>
void add_faces_below(materials::MaterialMesh& surface, double depth_m, IsInBorder is_in) {
  assert(depth_m >= 0);
  const double snapped_m = snapped(depth_m);
  for (const auto& [a, b] : edges_in_border(surface.mesh, is_in)) {
    const std::uint32_t below_a = add_lower(surface, a, snapped_m), below_b = add_lower(surface, b, snapped_m);
    surface.mesh.triangles.push_back({a, below_a, b});
    surface.mesh.triangles.push_back({b, below_a, below_b});
  }
}

}  // namespace

void add_skirt(materials::MaterialMesh& surface, const Box2& tile, double depth_m) {
  add_faces_below(surface, depth_m, [&](Vec3 a, Vec3 b) { return is_in_border(tile, a, b); });
}

void add_skirt(materials::MaterialMesh& surface, const std::set<std::pair<Vec3, Vec3>>& removed, double depth_m) {
  add_faces_below(surface, depth_m, [&](Vec3 a, Vec3 b) { return removed.contains({b, a}); });
}

}  // namespace citykiln::bake
