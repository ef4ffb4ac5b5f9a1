#include "compiler/buildings/terminal_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <span>

#include "compiler/buildings/paint_colour.h"
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

bool has_colour(const grammars::Appearance& look) { return look.red < 1 || look.green < 1 || look.blue < 1; }

bool turns_left(Vec3 in, Vec3 out, Vec3 normal) { return dot(cross(in, out), normal) > kLeast_m2; }

// The corner that does not turn left, or the first where all do; none where several do not.
std::optional<std::uint32_t> only_other_corner(std::span<const Vec3> ring, Vec3 normal) {
  std::uint32_t other = 0, count = 0, at = static_cast<std::uint32_t>(ring.size()) - 1;
  Vec3 in = ring[at] - ring[at - 1];
  for (std::uint32_t next = 0; next < ring.size() && count < 2; at = next++) {
    const Vec3 out = ring[next] - ring[at];
    if (!turns_left(in, out, normal)) other = at, ++count;
    in = out;
  }
  return count < 2 ? std::optional(other) : std::nullopt;
}

// Calls visit(a, b, c) with the corners of the ring's triangles about one of them.
template <typename Visit>
void each_of_fan(std::uint32_t hub, std::uint32_t count, Visit visit) {
  const auto after = [count](std::uint32_t corner) { return corner + 1 == count ? 0 : corner + 1; };
  std::uint32_t b = after(hub);
  for (std::uint32_t c = after(b); c != hub; b = c, c = after(c)) visit(hub, b, c);
}

// Where a fan of triangles that are not flat fills the ring: from any corner of a strictly convex one, and from the
// only corner that does not turn left. Of more than four corners one that goes round twice turns left everywhere too,
// but not as that corner sees it.
std::optional<std::uint32_t> hub_of(std::span<const Vec3> ring, Vec3 normal) {
  if (ring.size() < 3) return std::nullopt;
  const std::optional<std::uint32_t> hub = only_other_corner(ring, normal);
  bool is_hub = hub.has_value();
  if (is_hub && ring.size() > 4)
    each_of_fan(*hub, static_cast<std::uint32_t>(ring.size()), [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      is_hub = is_hub && turns_left(ring[b] - ring[a], ring[c] - ring[b], normal);
    });
  return is_hub ? hub : std::nullopt;
}

void add_fan(std::span<const Vec3> ring, std::uint32_t hub, Mesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), ring.begin(), ring.end());
  each_of_fan(hub, static_cast<std::uint32_t>(ring.size()), [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh.triangles.push_back({first + a, first + b, first + c});
  });
}

// Along the face's foot and up it; less whole periods, so that numbers stay small and neighbours in one plane agree.
void add_places(const Face& face, Vec3 normal, materials::MaterialMesh& dressed) {
  constexpr double kPeriod_m = materials::kTexturePeriod_m, kStep_m = materials::kTextureCoordinateStep_m;
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
  const std::optional<std::uint32_t> hub = is_whole ? hub_of(face.outer, normal) : std::nullopt;
  if (hub)
    add_fan(face.outer, *hub, mesh);
  else
    add_triangulated(face, mesh);
  return true;
}

void add_face(const Face& face, bool has_places, materials::MaterialMesh& dressed) {
  const Vec3 twice_m2 = area_vector_m2(face.outer), normal = unit(twice_m2);
  if (add_face(face, twice_m2, normal, dressed.mesh) && has_places) add_places(face, normal, dressed);
}

// Where what looks so goes.
struct Dress {
  materials::MaterialMesh* dressed;
  bool has_places;
};

// Room for all points, so that no mesh is moved as it grows.
void reserve_points(const grammars::Derivation& derivation, std::span<const Dress> dress_of_look) {
  std::vector<std::size_t> points(dress_of_look.size());
  for (const grammars::Terminal& terminal : derivation.terminals)
    points[terminal.appearance] += grammars::vertex_count(terminal.faces);
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

SurfaceMaterial surface_material_of(const grammars::Appearance& look) {
  const Material material = materials::material_named(look.name).value_or(Material::kPlaster);
  if (!has_colour(look)) return {material, materials::kNoTint};
  const LinearRgb paint = paint_reflectance({byte_of(look.red), byte_of(look.green), byte_of(look.blue)});
  // what is a little too light is cut off: better the material than the last shade
  const LinearRgb darker = {kCutOff * paint[0], kCutOff * paint[1], kCutOff * paint[2]};
  const Material shown = tintable_material(darker, {material, Material::kPaint});
  return {shown, tint_towards(shown, paint)};
}

void add_face(const Face& face, materials::MaterialMesh& dressed) {
  add_face(face, materials::has_texture(dressed.material, 0), dressed);
}

std::vector<materials::MaterialMesh> terminal_meshes(const grammars::Derivation& derivation, OsmId feature) {
  std::vector<SurfaceMaterial> dress;
  for (const grammars::Appearance& look : derivation.appearances) dress.push_back(surface_material_of(look));
  std::map<SurfaceMaterial, materials::MaterialMesh> mesh_of;
  for (const SurfaceMaterial& each : dress)
    mesh_of.try_emplace(each, materials::MaterialMesh{{}, each.material, each.tint, feature});
  std::vector<Dress> dress_of_look;
  for (const SurfaceMaterial& each : dress)
    dress_of_look.push_back({&mesh_of[each], materials::has_texture(each.material, 0)});
  reserve_points(derivation, dress_of_look);
  for (const grammars::Terminal& terminal : derivation.terminals) {
    const auto [dressed, has_places] = dress_of_look[terminal.appearance];
    for (const Face& face : terminal.faces) add_face(face, has_places, *dressed);
  }
  std::vector<materials::MaterialMesh> meshes;
  for (auto& [key, dressed] : mesh_of)
    if (!dressed.mesh.triangles.empty()) meshes.push_back(std::move(dressed));
  return meshes;
}

}  // namespace citykiln::buildings
