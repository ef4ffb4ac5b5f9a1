#include "compiler/bake/far/fade_roads.h"

#include <algorithm>
#include <deque>
#include <optional>
#include <utility>

#include "compiler/bake/tiles/weld.h"
#include "compiler/simplify/distance_bound.h"

namespace citykiln::bake {
namespace {

using simplify::Corners;
using Index = std::uint32_t;

bool fades(const Primitive& p) {
  const bool is_slab = p.layer == Layer::kGround && p.material == materials::Material::kFloorSlab;
  return p.uvs.empty() && (p.layer == Layer::kRoads || is_slab);
}

// Faces across each edge, by face and edge; a face with itself where there is none.
std::vector<std::array<Index, 3>> neighbours_of(const std::vector<Triangle>& faces) {
  struct Side {
    Index low, high, face, edge;
    auto operator<=>(const Side&) const = default;
  };
  std::vector<Side> sides;
  for (Index f = 0; f < faces.size(); ++f)
    for (Index i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(faces[f][i], faces[f][(i + 1) % 3]);
      sides.push_back({low, high, f, i});
    }
  std::ranges::sort(sides);
  std::vector<std::array<Index, 3>> neighbours;
  for (Index f = 0; f < faces.size(); ++f) neighbours.push_back({f, f, f});
  for (std::size_t s = 1; s < sides.size(); ++s) {
    const Side &a = sides[s - 1], &b = sides[s];
    if (a.low != b.low || a.high != b.high) continue;
    neighbours[a.face][a.edge] = b.face, neighbours[b.face][b.edge] = a.face;
  }
  return neighbours;
}

// For each fading face the nearest face of ground that takes it, found in rings of neighbours.
std::vector<std::optional<Index>> takers_of(const WeldedPrimitives& terrain, std::span<const Primitive> primitives) {
  const std::vector<Triangle>& faces = terrain.mesh.triangles;
  const std::vector<std::array<Index, 3>> neighbours = neighbours_of(faces);
  const auto primitive = [&](Index f) -> const Primitive& { return primitives[terrain.mesh.labels[f]]; };
  std::vector<std::optional<Index>> taker(faces.size());
  std::deque<Index> open;
  for (Index f = 0; f < faces.size(); ++f)
    if (primitive(f).layer == Layer::kGround && !fades(primitive(f)) && primitive(f).uvs.empty())
      taker[f] = f, open.push_back(f);
  for (; !open.empty(); open.pop_front())
    for (const Index n : neighbours[open.front()])
      if (!taker[n] && fades(primitive(n))) taker[n] = taker[open.front()], open.push_back(n);
  return taker;
}

Corners welded_corners(const WeldedPrimitives& terrain, Index face) {
  const auto& [a, b, c] = terrain.mesh.triangles[face];
  const std::vector<Vec3>& at = terrain.mesh.positions;
  return {at[a], at[b], at[c]};
}

// The triangles of each primitive.
std::vector<simplify::TriangleTree> trees_of(const WeldedPrimitives& terrain, std::size_t primitives) {
  std::vector<std::vector<Corners>> all(primitives);
  for (Index f = 0; f < terrain.mesh.triangles.size(); ++f)
    all[terrain.mesh.labels[f]].push_back(welded_corners(terrain, f));
  std::vector<simplify::TriangleTree> trees;
  for (std::vector<Corners>& triangles : all) trees.emplace_back(std::move(triangles));
  return trees;
}

// Adds a face of another primitive, in the colour of a vertex.
void add_recoloured_face(Primitive& to, const Primitive& from, const std::array<Index, 3>& vertices,
                         materials::Tint colour) {
  const auto first = static_cast<Index>(to.positions.size());
  for (const Index v : vertices) {
    to.positions.push_back(from.positions[v]), to.normals.push_back(from.normals[v]);
    to.colours.push_back(colour), to.features.push_back(0);
  }
  to.triangles.push_back({first, first + 1, first + 2});
}

}  // namespace

void fade_roads(BakedTile& tile, double tolerance_m) {
  constexpr double kPrecision = 0x1p-4;
  const WeldedPrimitives terrain = welded(tile.primitives, is_terrain);
  const std::vector<std::optional<Index>> takers = takers_of(terrain, tile.primitives);
  const std::vector<simplify::TriangleTree> trees = trees_of(terrain, tile.primitives.size());
  std::vector<Primitive> old = tile.primitives;
  for (Primitive& p : tile.primitives)
    if (is_terrain(p) && fades(p)) p = with_triangles(p, {});
  double farthest_m = 0;
  for (Index f = 0; f < takers.size(); ++f) {
    const Index own = terrain.mesh.labels[f];
    if (!fades(old[own])) continue;
    std::array<Index, 3> vertices{};
    for (std::size_t i = 0; i < 3; ++i) vertices[i] = terrain.vertex_at[own].at(terrain.mesh.triangles[f][i]);
    const Index label = takers[f] ? terrain.mesh.labels[*takers[f]] : own;
    const Corners corners = welded_corners(terrain, f);
    const double away_m = takers[f] ? distance_bound_m(std::span(&corners, 1), trees[label],
                                                       {.precision_m = kPrecision * tolerance_m, .most_m = tolerance_m})
                                    : 0;
    const bool stays = !takers[f] || away_m > tolerance_m;
    const Index like = stays ? vertices[0] : terrain.vertex_at[label].at(terrain.mesh.triangles[*takers[f]][0]);
    add_recoloured_face(tile.primitives[stays ? own : label], old[own], vertices,
                        old[stays ? own : label].colours[like]);
    if (!stays) farthest_m = std::max(farthest_m, away_m);
  }
  std::erase_if(tile.primitives, [](const Primitive& p) { return p.triangles.empty(); });
  tile.error_m += farthest_m;
}

}  // namespace citykiln::bake
