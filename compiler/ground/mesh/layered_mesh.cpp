#include "compiler/ground/mesh/layered_mesh.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace citykiln::ground {
namespace {

// A higher vertical face is a wall, not a kerb of the polygon above it.
constexpr double kHighestKerb_m = 0.3;

// Rounding can widen the point where a bore's mouth crosses the cell's border to an edge on the border. An edge that is
// shorter than this gets a wall of full height: an opening there would be a gap between tiles.
constexpr double kShortestMouth_m = 0.1;

constexpr std::uint32_t kNoNumber = 0xffffffffu;
using VertexByLayer = std::array<std::uint32_t, static_cast<std::size_t>(HeightLayer::kCount)>;

struct LayeredMeshBuilder {
  const Refined& refined;
  GradedNormals& normals;
  std::span<const FaceHeight> surfaces;
  std::span<const CellBorderPiece> cell_border;
  GroundMesh ground{};
  std::vector<VertexByLayer> numbers{};

  Vec3 place(std::uint32_t vertex, const FaceHeight& height) const {
    return at_height(plane_point(refined.triangulation.vertices()[vertex]),
                     layer_height_m(refined.heights[vertex], height));
  }

  Vec3 normal(std::uint32_t vertex, const FaceHeight& height) const {
    return height.level_m ? Vec3{0, 0, 1} : normals.at(refined.triangulation.vertices()[vertex], height.layer);
  }

  std::uint32_t add_vertex(Vec3 position, Vec3 normal) {
    ground.mesh.positions.push_back(position);
    ground.mesh.normals.push_back(normal);
    return static_cast<std::uint32_t>(ground.mesh.positions.size() - 1);
  }

  std::uint32_t vertex(std::uint32_t v, const FaceHeight& height) {
    std::uint32_t& number = numbers[v][static_cast<std::size_t>(height.layer)];
    const Vec3 p = place(v, height);
    // two waters may meet with a level each
    if (number != kNoNumber && ground.mesh.positions[number] == p) return number;
    const Vec3 up = normal(v, height);
    for (const std::uint32_t other : numbers[v])
      if (other != kNoNumber && ground.mesh.positions[other] == p && ground.mesh.normals[other] == up)
        return number = other;
    return number = add_vertex(p, up);
  }

  void add_face(std::uint32_t f) {
    const auto& v = refined.triangulation.faces()[f].vertices;
    const FaceHeight& height = refined.face_height[f];
    ground.mesh.triangles.push_back({vertex(v[0], height), vertex(v[1], height), vertex(v[2], height)});
    ground.face_cover.push_back(refined.face_cover[f]);
  }

  // Adds a vertical quad from the lower edge a → b to the upper one, with the upper face on the left; one triangle
  // where the edges meet at an end.
  void add_vertical_face(Vec3 a, Vec3 b, double upper_a, double upper_b, std::uint32_t upper_surface) {
    const bool is_wall = std::max(upper_a - a.z, upper_b - b.z) > kHighestKerb_m;
    const std::uint32_t surface = is_wall ? kNoLandCover : upper_surface;
    const Vec2 along = unit(in_plan(b) - in_plan(a));
    const Vec3 out = at_height(left_of(along) * -1.0, 0);
    const auto va = add_vertex(a, out), vb = add_vertex(b, out);
    const auto push = [&](std::uint32_t p, std::uint32_t q, std::uint32_t r) {
      ground.mesh.triangles.push_back({p, q, r});
      ground.face_cover.push_back(surface);
    };
    const auto ua = upper_a != a.z ? add_vertex({a.x, a.y, upper_a}, out) : va;
    const auto ub = upper_b != b.z ? add_vertex({b.x, b.y, upper_b}, out) : vb;
    if (ub != vb) push(va, vb, ub);
    if (ua != va) push(va, ub, ua);
  }

  // A vertical face across the mouth of a bore begins at its ceiling.
  Vec3 over_mouth(Vec3 a, Vec3 b, double upper_m) const {
    constexpr double kWithin_m = 0.25;
    const double ceiling_m = ceiling_in_mouth_m(normals.graded().bores, in_plan(a), in_plan(b), kWithin_m);
    return {a.x, a.y, std::clamp(ceiling_m, a.z, std::max(a.z, upper_m))};
  }

  // An edge of a face, which lies to the left of a → b.
  struct Ledge {
    Vec3 a, b;
    std::uint32_t surface;
  };

  Ledge ledge(std::uint32_t f, int i, const FaceHeight& height, std::uint32_t surface) const {
    const auto& v = refined.triangulation.faces()[f].vertices;
    return {place(v[(i + 1) % 3], height), place(v[(i + 2) % 3], height), surface};
  }

  static bool are_level(const Ledge& one, const Ledge& other) { return one.a == other.a && one.b == other.b; }
  // If ledges cross halfway, the one that is higher at the lower end in plan counts, so that both cells of a border
  // agree.
  static bool is_higher(const Ledge& one, const Ledge& other) {
    const double one_m = one.a.z + one.b.z, other_m = other.a.z + other.b.z;
    if (one_m != other_m) return one_m > other_m;
    return in_plan(one.a) < in_plan(one.b) ? one.a.z > other.a.z : one.b.z > other.b.z;
  }

  void add_below(const Ledge& upper, const Ledge& lower) {
    add_vertical_face(lower.a, lower.b, upper.a.z, upper.b.z, upper.surface);
  }

  // Adds the face below the upper ledge, and leaves a bore's mouth open.
  void add_below_leaving_mouth(const Ledge& upper, const Ledge& lower) {
    add_below(upper, {over_mouth(lower.a, lower.b, upper.a.z), over_mouth(lower.b, lower.a, upper.b.z), lower.surface});
  }

  // Closes the step between a face and its neighbour beyond edge i; done from the face with the lower number.
  void add_step(std::uint32_t f, int i) {
    const std::uint32_t beyond = refined.triangulation.faces()[f].neighbours[i];
    if (beyond == kNoFace) return add_cell_border_step(f, i);
    if (beyond < f || refined.face_height[f] == refined.face_height[beyond]) return;
    const Ledge own = ledge(f, i, refined.face_height[f], refined.face_cover[f]);
    const Ledge other = ledge(f, i, refined.face_height[beyond], refined.face_cover[beyond]);
    if (are_level(own, other)) return;
    if (is_higher(own, other))
      add_below_leaving_mouth(own, other);
    else
      add_below_leaving_mouth({other.b, other.a, other.surface}, {own.b, own.a, own.surface});
  }

  // Closes the step on the cell's border: the higher of both cells has the vertical face.
  void add_cell_border_step(std::uint32_t f, int i) {
    const CellBorderPiece* piece = piece_with(f, i);
    if (piece == nullptr || piece->beyond == refined.face_cover[f]) return;
    const FaceHeight height = piece->beyond == kNoLandCover ? FaceHeight{} : surfaces[piece->beyond];
    const Ledge own = ledge(f, i, refined.face_height[f], refined.face_cover[f]);
    const Ledge other = ledge(f, i, height, piece->beyond);
    if (are_level(own, other) || !is_higher(own, other)) return;
    if (length(in_plan(own.b) - in_plan(own.a)) < kShortestMouth_m)
      add_below(own, other);
    else
      add_below_leaving_mouth(own, other);
  }

  const CellBorderPiece* piece_with(std::uint32_t f, int i) const {
    const auto& v = refined.triangulation.faces()[f].vertices;
    const GridPoint from = refined.triangulation.vertices()[v[(i + 1) % 3]],
                    to = refined.triangulation.vertices()[v[(i + 2) % 3]];
    const GridPoint a = std::min(from, to), b = std::max(from, to);
    const auto holds = [&](const CellBorderPiece& piece) {
      const bool is_in_line = a.x == b.x ? piece.a.x == a.x && piece.b.x == a.x : piece.a.y == a.y && piece.b.y == a.y;
      return is_in_line && piece.a <= a && b <= piece.b;
    };
    const auto found = std::ranges::find_if(cell_border, holds);
    return found == cell_border.end() ? nullptr : &*found;
  }
};

}  // namespace

GroundMesh layered_mesh(const Refined& refined, GradedNormals& normals, std::span<const FaceHeight> surfaces,
                        std::span<const CellBorderPiece> cell_border) {
  assert(refined.heights.size() == refined.triangulation.vertices().size());
  VertexByLayer none;
  none.fill(kNoNumber);
  LayeredMeshBuilder builder{refined, normals, surfaces, cell_border};
  builder.numbers.assign(refined.triangulation.vertices().size(), none);
  const auto faces = static_cast<std::uint32_t>(refined.triangulation.faces().size());
  for (std::uint32_t f = 0; f < faces; ++f) builder.add_face(f);
  builder.ground.first_vertical = faces;
  for (std::uint32_t f = 0; f < faces; ++f)
    for (int i = 0; i < 3; ++i) builder.add_step(f, i);
  builder.ground.error_m = refined.error_m;
  return std::move(builder.ground);
}

}  // namespace citykiln::ground
