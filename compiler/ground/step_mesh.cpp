#include "compiler/ground/step_mesh.h"

#include <algorithm>
#include <array>

namespace citykiln::ground {
namespace {

// What is higher is no kerb of the surface above it but a wall.
constexpr double kHighestKerb_m = 0.3;

constexpr std::uint32_t kNoVertex = 0xffffffffu;
using VertexByLayer = std::array<std::uint32_t, static_cast<std::size_t>(HeightLayer::kCount)>;

struct Builder {
  const Refined& refined;
  CarvedNormals& normals;
  GroundMesh ground{};
  std::vector<VertexByLayer> numbers{};

  Vec3 place(std::uint32_t vertex, const FaceHeight& height) const {
    return at_height(plane_point(refined.triangulation.vertices()[vertex]), of(refined.heights[vertex], height));
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
    if (number != kNoVertex && ground.mesh.positions[number] == p) return number;
    const Vec3 up = normal(v, height);
    for (const std::uint32_t other : numbers[v])
      if (other != kNoVertex && ground.mesh.positions[other] == p && ground.mesh.normals[other] == up)
        return number = other;
    return number = add_vertex(p, up);
  }

  void add_face(std::uint32_t f) {
    const auto& v = refined.triangulation.faces()[f].vertices;
    const FaceHeight& height = refined.face_height[f];
    ground.mesh.triangles.push_back({vertex(v[0], height), vertex(v[1], height), vertex(v[2], height)});
    ground.face_surface.push_back(refined.face_surface[f]);
  }

  // An upright quad from the lower edge a → b to the upper one, the upper face to the left of it; one triangle where
  // the edges meet at an end.
  void add_upright(Vec3 a, Vec3 b, double upper_a, double upper_b, std::uint32_t upper_surface) {
    const bool is_wall = std::max(upper_a - a.z, upper_b - b.z) > kHighestKerb_m;
    const std::uint32_t surface = is_wall ? kNoSurface : upper_surface;
    const Vec2 along = unit(in_plan(b) - in_plan(a));
    const Vec3 out = at_height(left_of(along) * -1.0, 0);
    const auto va = add_vertex(a, out), vb = add_vertex(b, out);
    const auto push = [&](std::uint32_t p, std::uint32_t q, std::uint32_t r) {
      ground.mesh.triangles.push_back({p, q, r});
      ground.face_surface.push_back(surface);
    };
    const auto ua = upper_a != a.z ? add_vertex({a.x, a.y, upper_a}, out) : va;
    const auto ub = upper_b != b.z ? add_vertex({b.x, b.y, upper_b}, out) : vb;
    if (ub != vb) push(va, vb, ub);
    if (ua != va) push(va, ub, ua);
  }

  // A step across the mouth of a bore begins at its ceiling.
  Vec3 over_mouth(Vec3 a, Vec3 b, double upper_m) const {
    constexpr double kWithin_m = 0.25;
    const double ceiling_m = ceiling_in_mouth_m(normals.carving().bores, in_plan(a), in_plan(b), kWithin_m);
    return {a.x, a.y, std::clamp(ceiling_m, a.z, std::max(a.z, upper_m))};
  }

  // The step between a face and its neighbour beyond edge i, seen once.
  void add_step(std::uint32_t f, int i) {
    const DelaunayFace& face = refined.triangulation.faces()[f];
    const std::uint32_t beyond = face.neighbours[i];
    if (beyond == kNoFace || beyond < f || refined.face_height[f] == refined.face_height[beyond]) return;
    const std::uint32_t from = face.vertices[(i + 1) % 3], to = face.vertices[(i + 2) % 3];
    const Vec3 own_a = place(from, refined.face_height[f]), own_b = place(to, refined.face_height[f]);
    const Vec3 other_a = place(from, refined.face_height[beyond]), other_b = place(to, refined.face_height[beyond]);
    if (own_a == other_a && own_b == other_b) return;
    if (own_a.z + own_b.z >= other_a.z + other_b.z)
      add_upright(over_mouth(other_a, other_b, own_a.z), over_mouth(other_b, other_a, own_b.z), own_a.z, own_b.z,
                  refined.face_surface[f]);
    else
      add_upright(over_mouth(own_b, own_a, other_b.z), over_mouth(own_a, own_b, other_a.z), other_b.z, other_a.z,
                  refined.face_surface[beyond]);
  }
};

}  // namespace

GroundMesh step_mesh(const Refined& refined, CarvedNormals& normals) {
  VertexByLayer none;
  none.fill(kNoVertex);
  Builder builder{refined, normals};
  builder.numbers.assign(refined.triangulation.vertices().size(), none);
  const auto faces = static_cast<std::uint32_t>(refined.triangulation.faces().size());
  for (std::uint32_t f = 0; f < faces; ++f) builder.add_face(f);
  builder.ground.first_upright = faces;
  for (std::uint32_t f = 0; f < faces; ++f)
    for (int i = 0; i < 3; ++i) builder.add_step(f, i);
  builder.ground.error_m = refined.error_m;
  return std::move(builder.ground);
}

}  // namespace citykiln::ground
