#include "compiler/buildings/dress_terminals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>

#include "compiler/buildings/painted.h"
#include "compiler/geometry/triangulate.h"
#include "compiler/materials/texture.h"

namespace citykiln::buildings {
namespace {

using grammars::Face;
using materials::Material;

// Less is a crack, square metres.
constexpr double kLeast_m2 = 1e-9;

// A colour that is lighter than the material by up to a third is not painted over it.
constexpr double kCutOff = 0.75;

std::uint8_t byte_of(double share) { return static_cast<std::uint8_t>(std::clamp(share, 0.0, 1.0) * 255 + 0.5); }

bool has_colour(const grammars::Look& look) { return look.red < 1 || look.green < 1 || look.blue < 1; }

bool turns_left(Vec3 in, Vec3 out, Vec3 normal) { return dot(cross(in, out), normal) > kLeast_m2; }

bool turns_left_everywhere(std::span<const Vec3> ring, Vec3 normal) {
  Vec3 before = ring.back(), in = before - ring[ring.size() - 2];
  for (const Vec3 p : ring) {
    const Vec3 out = p - before;
    if (!turns_left(in, out, normal)) return false;
    before = p, in = out;
  }
  return true;
}

// Strictly: then a fan from any corner has no flat triangle. Of more than four corners one that goes round twice turns
// left everywhere too, but not as its first corner sees it.
bool is_convex(std::span<const Vec3> ring, Vec3 normal) {
  bool is = ring.size() >= 3 && turns_left_everywhere(ring, normal);
  for (std::size_t i = 2; ring.size() > 4 && i < ring.size() && is; ++i)
    is = turns_left(ring[i - 1] - ring[0], ring[i] - ring[i - 1], normal);
  return is;
}

void add_fan(std::span<const Vec3> ring, Mesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), ring.begin(), ring.end());
  for (std::uint32_t i = 2; i < ring.size(); ++i) mesh.triangles.push_back({first, first + i - 1, first + i});
}

// Along the face's foot and up it; less whole periods, so that numbers stay small and neighbours in one plane agree.
void add_places(const Face& face, Vec3 normal, materials::DressedMesh& dressed) {
  constexpr double kPeriod_m = materials::kTexturePeriod_m, kStep_m = materials::kTexturePlace_m;
  const std::array<Vec3, 3> axis = grammars::axes_of(face, normal);
  const auto period = [&](std::size_t i) {
    return std::floor(dot(axis[i], face.outer.front()) / kPeriod_m) * kPeriod_m;
  };
  const Vec2 whole{period(0), period(1)};
  const auto on_grid = [&](double m) { return std::floor(m / kStep_m + 0.5) * kStep_m; };
  for (std::size_t i = dressed.uvs.size(); i < dressed.mesh.positions.size(); ++i) {
    const Vec3 p = dressed.mesh.positions[i];
    dressed.uvs.push_back({on_grid(dot(axis[0], p) - whole.x), on_grid(dot(axis[1], p) - whole.y)});
  }
}

// The face's own points, in the order in which triangulate() counts them.
std::vector<Vec3> points_of(const Face& face) {
  std::vector<Vec3> points;
  each_vertex(face, [&](Vec3 p) { points.push_back(p); });
  return points;
}

void add_triangulated(const Face& face, Mesh& mesh) {
  const grammars::FaceFrame frame = frame_of(face);
  const PlaneTriangles plane = triangulate(flat(face, frame));
  const std::vector<Vec3> own = points_of(face);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (std::size_t i = 0; i < plane.points.size(); ++i)
    mesh.positions.push_back(i < own.size() ? own[i] : frame.to_space(plane.points[i]));
  for (const Triangle& t : plane.triangles) mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

// False, and nothing is added, for a face without area. Which way it looks, and how large it is, its outer ring says
// for both.
bool add_face(const Face& face, Vec3 twice_outer_m2, Vec3 normal, Mesh& mesh) {
  const bool is_whole = face.holes.empty();
  const double area = (is_whole ? length(twice_outer_m2) : length(area_vector_m2(face))) / 2;
  if (area < kLeast_m2) return false;
  if (is_whole && is_convex(face.outer, normal))
    add_fan(face.outer, mesh);
  else
    add_triangulated(face, mesh);
  return true;
}

void add_face(const Face& face, bool has_places, materials::DressedMesh& dressed) {
  const Vec3 twice_m2 = area_vector_m2(face.outer), normal = unit(twice_m2);
  if (add_face(face, twice_m2, normal, dressed.mesh) && has_places) add_places(face, normal, dressed);
}

// Where what looks so goes.
struct Dress {
  materials::DressedMesh* dressed;
  bool has_places;
};

// Room for all points, so that no mesh is moved as it grows.
void reserve_points(const grammars::Derivation& derivation, std::span<const Dress> dress_of_look) {
  std::vector<std::size_t> points(dress_of_look.size());
  for (const grammars::Terminal& terminal : derivation.terminals)
    points[terminal.look] += grammars::vertex_count(terminal.faces);
  for (std::size_t look = 0; look < points.size(); ++look) {
    const auto [dressed, has_places] = dress_of_look[look];
    const std::size_t all = dressed->mesh.positions.capacity() + points[look];
    dressed->mesh.positions.reserve(all);
    dressed->mesh.triangles.reserve(all / 2);
    if (has_places) dressed->uvs.reserve(all);
  }
}

}  // namespace

void add_face(const Face& face, Mesh& mesh) {
  const Vec3 twice_m2 = area_vector_m2(face.outer);
  add_face(face, twice_m2, unit(twice_m2), mesh);
}

SurfaceDress dress_of(const grammars::Look& look) {
  const Material material = materials::material_named(look.name).value_or(Material::kPlaster);
  if (!has_colour(look)) return {material, materials::kNoTint};
  const Linear paint = paint_of({byte_of(look.red), byte_of(look.green), byte_of(look.blue)});
  // what is a little too light is cut off: better the material than the last shade
  const Linear darker = {kCutOff * paint[0], kCutOff * paint[1], kCutOff * paint[2]};
  const Material shown = showing(darker, {material, Material::kPaint});
  return {shown, painted(shown, paint)};
}

void add_face(const Face& face, materials::DressedMesh& dressed) {
  add_face(face, materials::has_texture(dressed.material, 0), dressed);
}

std::vector<materials::DressedMesh> meshes_of(const grammars::Derivation& derivation, OsmId feature) {
  std::vector<SurfaceDress> dress;
  for (const grammars::Look& look : derivation.looks) dress.push_back(dress_of(look));
  std::map<SurfaceDress, materials::DressedMesh> mesh_of;
  for (const SurfaceDress& each : dress) mesh_of[each] = {{}, each.material, each.tint, feature};
  std::vector<Dress> dress_of_look;
  for (const SurfaceDress& each : dress)
    dress_of_look.push_back({&mesh_of[each], materials::has_texture(each.material, 0)});
  reserve_points(derivation, dress_of_look);
  for (const grammars::Terminal& terminal : derivation.terminals) {
    const auto [dressed, has_places] = dress_of_look[terminal.look];
    for (const Face& face : terminal.faces) add_face(face, has_places, *dressed);
  }
  std::vector<materials::DressedMesh> meshes;
  for (auto& [key, dressed] : mesh_of)
    if (!dressed.mesh.triangles.empty()) meshes.push_back(std::move(dressed));
  return meshes;
}

}  // namespace citykiln::buildings
