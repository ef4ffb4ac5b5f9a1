#include "compiler/bake/clip_to_outline.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "compiler/bake/cut_vertices.h"
#include "compiler/geometry/box.h"
#include "compiler/geometry/snap.h"

namespace citykiln::bake {
namespace {

using materials::MaterialMesh;

struct ClipEdge {
  Vec2 from, to;
};

std::vector<ClipEdge> edges_near(const scene::Clip& clip, const Box2& box) {
  std::vector<ClipEdge> edges;
  for (const Polygon& polygon : clip)
    for (const Ring* ring : rings_of(polygon))
      for (std::size_t i = 0; i < ring->size(); ++i) {
        const Vec2 a = (*ring)[i], b = (*ring)[(i + 1) % ring->size()];
        if (box_of_segment(a, b).touches(box)) edges.push_back({a, b});
      }
  return edges;
}

Box2 plan_box(const Mesh& mesh) {
  Box2 box;
  for (const Vec3 p : mesh.positions) box.grow(in_plan(p));
  return box;
}

using Piece = std::vector<std::uint32_t>;  // the corners of a convex polygon

// A mesh while it is split along the lines of edges.
class SplitMesh {
 public:
  SplitMesh(MaterialMesh& mesh, const std::vector<ClipEdge>& edges) : mesh_(mesh), edges_(edges) {}

  // The pieces of a triangle between the lines of the edges near it.
  std::vector<Piece> pieces_of(const Triangle& t) {
    Box2 box;
    for (const std::uint32_t v : t) box.grow(in_plan(mesh_.mesh.positions[v]));
    std::vector<Piece> pieces = {{t[0], t[1], t[2]}};
    for (std::uint32_t e = 0; e < edges_.size(); ++e)
      if (box_of_segment(edges_[e].from, edges_[e].to).touches(box)) pieces = split(pieces, e);
    return pieces;
  }

  Vec2 middle_of(const Piece& piece) const {
    Vec2 sum{};
    for (const std::uint32_t v : piece) sum = sum + in_plan(mesh_.mesh.positions[v]);
    return sum * (1.0 / static_cast<double>(piece.size()));
  }

 private:
  // Greater than 0 to the left of an edge; 0 for vertices on it.
  double side_of(std::uint32_t v, std::uint32_t e) const {
    const ClipEdge& edge = edges_[e];
    const Vec2 along = edge.to - edge.from;
    const double off_m = cross(along, in_plan(mesh_.mesh.positions[v]) - edge.from) / length(along);
    return std::abs(off_m) <= kQuantum_m ? 0 : off_m;
  }

  std::vector<Piece> split(const std::vector<Piece>& pieces, std::uint32_t e) {
    std::vector<Piece> all;
    for (const Piece& piece : pieces)
      for (const double sign : {1.0, -1.0})
        if (Piece half = half_of(piece, e, sign); half.size() >= 3) all.push_back(std::move(half));
    return all;
  }

  // The part of a piece on one side; nothing if it only touches the line there.
  Piece half_of(const Piece& piece, std::uint32_t e, double sign) {
    Piece half;
    bool has_inside = false;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const std::uint32_t a = piece[i], b = piece[(i + 1) % piece.size()];
      const double side_a = side_of(a, e) * sign, side_b = side_of(b, e) * sign;
      has_inside = has_inside || side_a > 0;
      if (side_a >= 0) half.push_back(a);
      if (side_a * side_b < 0) half.push_back(crossing(a, b, e));
    }
    const bool lies_in_line = sign > 0 && !has_inside && half.size() == piece.size();
    return has_inside || lies_in_line ? half : Piece{};
  }

  std::uint32_t crossing(std::uint32_t a, std::uint32_t b, std::uint32_t e) {
    if (mesh_.mesh.positions[b] < mesh_.mesh.positions[a]) std::swap(a, b);
    const auto next = static_cast<std::uint32_t>(mesh_.mesh.positions.size());
    const auto [found, is_new] = crossings_.try_emplace({a, b, e}, next);
    if (!is_new) return found->second;
    const double side_a = side_of(a, e), side_b = side_of(b, e);
    add_vertex_between(mesh_, a, b, side_a / (side_a - side_b));
    return next;
  }

  MaterialMesh& mesh_;
  const std::vector<ClipEdge>& edges_;
  std::map<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>, std::uint32_t> crossings_{};
};

void clip_mesh(MaterialMesh& whole, const scene::Clip& clip) {
  if (whole.mesh.triangles.empty()) return;
  const Box2 box = plan_box(whole.mesh).widened(1);
  const scene::ClipTest test(clip, box);
  const std::vector<ClipEdge> edges = edges_near(clip, box);
  if (edges.empty() && test.is_inside(box.centre())) return;
  SplitMesh split(whole, edges);
  std::vector<Triangle> kept;
  for (const Triangle& t : std::exchange(whole.mesh.triangles, {}))
    for (const Piece& piece : split.pieces_of(t)) {
      if (!test.is_inside(split.middle_of(piece))) continue;
      for (std::size_t i = 1; i + 1 < piece.size(); ++i) kept.push_back({piece[0], piece[i], piece[i + 1]});
    }
  whole.mesh.triangles = std::move(kept);
  drop_unused_vertices(whole);
}

}  // namespace

void clip_to_outline(std::span<MaterialMesh* const> meshes, const scene::Clip& clip) {
  assert(std::ranges::none_of(meshes, [](const MaterialMesh* mesh) { return mesh == nullptr; }));
  if (clip.empty()) return;
  for (MaterialMesh* mesh : meshes) clip_mesh(*mesh, clip);
}

}  // namespace citykiln::bake
