#include "compiler/bake/clip_to_extent.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <utility>

#include "compiler/bake/cut_vertices.h"
#include "compiler/geometry/triangles/triangulate.h"

namespace citykiln::bake {
namespace {

using materials::MaterialMesh;

// A side of the extent: the vertical plane where one coordinate has a value.
struct Side {
  double Vec3::*coordinate;
  double at_m;
  double outwards;  // 1 if the extent lies below at_m, -1 if above

  // Greater than 0 inside.
  double depth_m(Vec3 p) const { return (at_m - p.*coordinate) * outwards; }
  // Coordinates in the plane, seen from outside: to the right, and up.
  Vec2 flat(Vec3 p) const { return coordinate == &Vec3::x ? Vec2{p.y * outwards, p.z} : Vec2{-p.x * outwards, p.z}; }
  Vec3 in_space(Vec2 flat) const {
    return coordinate == &Vec3::x ? Vec3{at_m, flat.x * outwards, flat.y} : Vec3{-flat.x * outwards, at_m, flat.y};
  }
};

std::array<Side, 4> sides_of(const Box2& box) {
  return {Side{&Vec3::x, box.min.x, -1}, {&Vec3::x, box.max.x, 1}, {&Vec3::y, box.min.y, -1}, {&Vec3::y, box.max.y, 1}};
}

// A mesh while one side cuts it.
struct MeshCut {
  MaterialMesh& whole;
  const Side& side;
  std::vector<double> depths_m{};
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> crossings{};

  // The vertex where an edge crosses the side. Both directions of an edge, and equal edges of other meshes, give the
  // same vertex.
  std::uint32_t crossing(std::uint32_t a, std::uint32_t b) {
    if (whole.mesh.positions[b] < whole.mesh.positions[a]) std::swap(a, b);
    const auto [found, is_new] = crossings.try_emplace({a, b}, static_cast<std::uint32_t>(depths_m.size()));
    if (is_new) add_between(a, b, depths_m[a] / (depths_m[a] - depths_m[b]));
    return found->second;
  }
  void add_between(std::uint32_t a, std::uint32_t b, double share) {
    add_vertex_between(whole, a, b, share);
    whole.mesh.positions.back().*side.coordinate = side.at_m;
    depths_m.push_back(0);
  }
  // The part of a triangle inside, as the corners of a convex polygon.
  std::vector<std::uint32_t> inside(const Triangle& t) {
    std::vector<std::uint32_t> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3];
      if (depths_m[a] >= 0) corners.push_back(a);
      if ((depths_m[a] > 0 && depths_m[b] < 0) || (depths_m[a] < 0 && depths_m[b] > 0))
        corners.push_back(crossing(a, b));
    }
    return corners;
  }
};

// Returns whether anything was cut off.
bool clip_to_side(MaterialMesh& whole, const Side& side) {
  MeshCut cut{whole, side};
  for (const Vec3 p : whole.mesh.positions) cut.depths_m.push_back(side.depth_m(p));
  if (std::ranges::all_of(cut.depths_m, [](double depth_m) { return depth_m >= 0; })) return false;
  std::vector<Triangle> kept;
  for (const Triangle& t : std::exchange(whole.mesh.triangles, {})) {
    const std::vector<std::uint32_t> corners = cut.inside(t);
    const bool has_inside = std::ranges::any_of(t, [&](std::uint32_t v) { return cut.depths_m[v] > 0; });
    const bool lies_in_side = std::ranges::all_of(t, [&](std::uint32_t v) { return cut.depths_m[v] == 0; });
    if (!has_inside && !lies_in_side) continue;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) kept.push_back({corners[0], corners[i], corners[i + 1]});
  }
  whole.mesh.triangles = std::move(kept);
  drop_unused_vertices(whole);
  return true;
}

// Directed edges between places of a side, by their begin.
using Borders = std::multimap<Vec2, Vec2>;

// The borders of the meshes that lie in a side. An edge that two faces share is no border.
Borders borders_in(std::span<MaterialMesh* const> meshes, const Side& side) {
  std::map<std::pair<Vec2, Vec2>, int> edges;
  for (const MaterialMesh* mesh : meshes)
    for (const Triangle& t : mesh->mesh.triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 a = mesh->mesh.positions[t[i]], b = mesh->mesh.positions[t[(i + 1) % 3]];
        if (side.depth_m(a) != 0 || side.depth_m(b) != 0 || a == b) continue;
        const Vec2 from = side.flat(a), to = side.flat(b);
        from < to ? ++edges[{from, to}] : --edges[{to, from}];
      }
  Borders borders;
  for (const auto& [edge, count] : edges)
    for (int i = 0; i < std::abs(count); ++i)
      count > 0 ? borders.emplace(edge.first, edge.second) : borders.emplace(edge.second, edge.first);
  return borders;
}

// An edge that no other edge leads to, where an open chain begins; else any.
Borders::iterator first_edge(Borders& borders) {
  std::set<Vec2> reached;
  for (const auto& [from, to] : borders) reached.insert(to);
  const auto open = std::ranges::find_if(borders, [&](const auto& edge) { return !reached.contains(edge.first); });
  return open == borders.end() ? borders.begin() : open;
}

// Takes the edges of one ring, or of an open chain, out of `borders`.
Ring take_ring(Borders& borders) {
  Ring ring;
  auto edge = first_edge(borders);
  while (edge != borders.end()) {
    ring.push_back(edge->first);
    const Vec2 to = edge->second;
    borders.erase(edge);
    if (to == ring.front()) break;
    edge = borders.find(to);
    if (edge == borders.end()) ring.push_back(to);
  }
  return ring;
}

void close(std::span<MaterialMesh* const> meshes, const Side& side, Mesh& caps) {
  Borders borders = borders_in(meshes, side);
  while (!borders.empty()) {
    const PlaneTriangles cap = triangulate({take_ring(borders), {}});
    const auto first = static_cast<std::uint32_t>(caps.positions.size());
    for (const Vec2 p : cap.points) caps.positions.push_back(side.in_space(p));
    for (const Triangle& t : cap.triangles) caps.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
}

}  // namespace

void clip_to_extent(std::span<MaterialMesh* const> meshes, const Box2& extent) {
  assert(std::ranges::none_of(meshes, [](const MaterialMesh* mesh) { return mesh == nullptr; }));
  for (const Side& side : sides_of(extent))
    for (MaterialMesh* mesh : meshes) clip_to_side(*mesh, side);
}

Mesh clip_solid_to_extent(std::span<MaterialMesh* const> meshes, const Box2& extent) {
  assert(std::ranges::none_of(meshes, [](const MaterialMesh* mesh) { return mesh == nullptr; }));
  MaterialMesh caps;
  std::vector<MaterialMesh*> all(meshes.begin(), meshes.end());
  all.push_back(&caps);
  for (const Side& side : sides_of(extent)) {
    bool is_cut = false;
    for (MaterialMesh* mesh : all) is_cut |= clip_to_side(*mesh, side);
    if (is_cut) close(all, side, caps.mesh);
  }
  return std::move(caps.mesh);
}

}  // namespace citykiln::bake
