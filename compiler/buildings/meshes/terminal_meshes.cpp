#include "compiler/buildings/meshes/terminal_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <span>

#include "compiler/buildings/meshes/railings.h"
#include "compiler/buildings/styles/paint_colour.h"
#include "compiler/contract/detail_tolerances.h"
#include "compiler/geometry/triangles/triangulate.h"
#include "compiler/materials/texture.h"

namespace citykiln::buildings {
namespace {

using grammars::Face;
using materials::Material;
using materials::MaterialMesh;
using materials::SurfaceMaterial;
using FacesBySurface = std::map<SurfaceMaterial, std::vector<DerivedFace>>;

// Smaller faces and turns are rounding errors.
constexpr double kMinFaceArea_m2 = 1e-9;

// Share of the colour that the material has to be able to show: a colour lighter by up to a third is clamped to the
// material's own rather than painted over it.
constexpr double kMinShownShare = 0.75;

std::uint8_t byte_of(double share) { return static_cast<std::uint8_t>(std::clamp(share, 0.0, 1.0) * 255 + 0.5); }

bool turns_left(Vec3 in, Vec3 out, Vec3 normal) { return dot(cross(in, out), normal) > kMinFaceArea_m2; }

// The reflex corner of a ring, or its first if there is none; nothing if there are several.
std::optional<std::uint32_t> only_reflex_corner(std::span<const Vec3> ring, Vec3 normal) {
  std::uint32_t reflex = 0, count = 0, at = static_cast<std::uint32_t>(ring.size()) - 1;
  Vec3 in = ring[at] - ring[at - 1];
  for (std::uint32_t next = 0; next < ring.size() && count < 2; at = next++) {
    const Vec3 out = ring[next] - ring[at];
    if (!turns_left(in, out, normal)) reflex = at, ++count;
    in = out;
  }
  return count < 2 ? std::optional(reflex) : std::nullopt;
}

// Calls visit(a, b, c) with the corners of the triangles of a fan around one corner.
template <typename Visit>
void each_of_fan(std::uint32_t hub, std::uint32_t count, Visit visit) {
  const auto after = [count](std::uint32_t corner) { return corner + 1 == count ? 0 : corner + 1; };
  std::uint32_t b = after(hub);
  for (std::uint32_t c = after(b); c != hub; b = c, c = after(c)) visit(hub, b, c);
}

// The corner around which a triangle fan fills the ring: any corner of a strictly convex ring, or the only reflex
// corner. A ring of more than four corners that winds twice also turns left everywhere, so the fan's triangles are
// checked.
std::optional<std::uint32_t> hub_of(std::span<const Vec3> ring, Vec3 normal) {
  if (ring.size() < 3) return std::nullopt;
  const std::optional<std::uint32_t> hub = only_reflex_corner(ring, normal);
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

// Adds texture coordinates along the face's lower edge and up it. Whole periods are subtracted: coordinates stay small
// and coplanar neighbours agree.
void add_uvs(const Face& face, Vec3 normal, MaterialMesh& mesh) {
  constexpr double kPeriod_m = materials::kTexturePeriod_m, kStep_m = materials::kTextureCoordinateStep_m;
  const std::array<Vec3, 3> axis = grammars::axes_of(face, normal);
  const auto periods_m = [&](Vec3 a) { return std::floor(dot(a, face.outer.front()) / kPeriod_m) * kPeriod_m; };
  const Vec2 whole{periods_m(axis[0]), periods_m(axis[1])};
  const auto on_grid = [&](double m) { return std::floor(m / kStep_m + 0.5) * kStep_m; };
  for (std::size_t i = mesh.uvs.size(); i < mesh.mesh.positions.size(); ++i) {
    const Vec3 p = mesh.mesh.positions[i];
    mesh.uvs.push_back({on_grid(dot(axis[0], p) - whole.x), on_grid(dot(axis[1], p) - whole.y)});
  }
}

void add_triangulated(const Face& face, Mesh& mesh) {
  const grammars::FaceFrame frame = frame_of(face);
  const PlaneTriangles plane = triangulate(flat(face, frame));
  // the first vertices of the triangulation are the face's own points, which projection would round
  std::vector<Vec3> own;
  each_vertex(face, [&](Vec3 p) { own.push_back(p); });
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (std::size_t i = 0; i < plane.points.size(); ++i)
    mesh.positions.push_back(i < own.size() ? own[i] : frame.to_space(plane.points[i]));
  for (const Triangle& t : plane.triangles) mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

// Returns false for a face without area. The vector area of the outer ring is computed once for size and normal.
bool add_face_with_normal(const Face& face, Vec3 twice_outer_m2, Vec3 normal, Mesh& mesh) {
  const bool has_holes = !face.holes.empty();
  const double area = length(has_holes ? double_area_vector_m2(face) : twice_outer_m2) / 2;
  if (area < kMinFaceArea_m2) return false;
  const std::optional<std::uint32_t> hub = has_holes ? std::nullopt : hub_of(face.outer, normal);
  if (hub)
    add_fan(face.outer, *hub, mesh);
  else
    add_triangulated(face, mesh);
  return true;
}

void add_material_face(const Face& face, bool has_uvs, MaterialMesh& mesh) {
  const Vec3 twice_m2 = double_area_vector_m2(face.outer), normal = unit(twice_m2);
  if (!add_face_with_normal(face, twice_m2, normal, mesh.mesh) || !has_uvs) return;
  if (mesh.material == Material::kRailing)
    add_railing_uvs(face, mesh);
  else
    add_uvs(face, normal, mesh);
}

// Growing meshes step by step would copy them several times.
void reserve_points(std::span<const DerivedFace> faces, bool has_uvs, MaterialMesh& mesh) {
  std::size_t points = 0;
  for (const DerivedFace& derived : faces) points += grammars::vertex_count(std::span(&derived.face, 1));
  mesh.mesh.positions.reserve(points), mesh.mesh.triangles.reserve(points / 2);
  if (has_uvs) mesh.uvs.reserve(points);
}

// Texture coordinates keep faces from sharing corners, so that small faces, of which windows have many, would take
// twice the bytes. Where bumps are left out too they have the mean colour: below an area on which a pattern without
// units shows nothing, or a few units.
bool shows_texture(const DerivedFace& derived, Material material, double tolerance_m) {
  constexpr double kLeastPlain_m2 = 3, kLeastUnits_m2 = 0.4;
  if (!materials::has_texture(material, tolerance_m)) return false;
  if (material == Material::kRailing || has_detail(Detail::kGroundNormals, tolerance_m)) return true;
  const double least_m2 = materials::has_no_units(material) ? kLeastPlain_m2 : kLeastUnits_m2;
  return length(double_area_vector_m2(derived.face)) / 2 >= least_m2;
}

void add_faces(std::span<const DerivedFace> faces, bool has_uvs, MaterialMesh& mesh) {
  reserve_points(faces, has_uvs, mesh);
  for (const DerivedFace& derived : faces) add_material_face(derived.face, has_uvs, mesh);
}

void add_bars(std::span<const DerivedFace> railings, MaterialMesh& mesh) {
  for (const DerivedFace& railing : railings)
    for (const Face& part : parts_of_railing(railing.face)) add_face(part, mesh.mesh);
}

// The faces of a surface as two meshes, with texture coordinates and without, of which either may be empty.
std::array<MaterialMesh, 2> textured_and_plain(const MaterialMesh& blank, std::span<const DerivedFace> faces,
                                               double tolerance_m) {
  std::array<std::vector<DerivedFace>, 2> parts;
  for (const DerivedFace& face : faces) parts[shows_texture(face, blank.material, tolerance_m) ? 0 : 1].push_back(face);
  std::array<MaterialMesh, 2> meshes{blank, blank};
  for (std::size_t i = 0; i < parts.size(); ++i) add_faces(parts[i], i == 0, meshes[i]);
  return meshes;
}

}  // namespace

void add_face(const Face& face, Mesh& mesh) {
  const Vec3 twice_m2 = double_area_vector_m2(face.outer);
  add_face_with_normal(face, twice_m2, unit(twice_m2), mesh);
}

void add_face(const Face& face, MaterialMesh& mesh) {
  add_material_face(face, materials::has_texture(mesh.material, 0), mesh);
}

SurfaceMaterial surface_material_of(const grammars::Appearance& appearance) {
  const Material material = materials::material_named(appearance.name).value_or(Material::kPlaster);
  const auto [red, green, blue] = std::tuple(appearance.red, appearance.green, appearance.blue);
  if (red >= 1 && green >= 1 && blue >= 1) return {material, materials::kNoTint};
  // plaster of all colours has one texture
  const Material base = material == Material::kPlaster ? Material::kLightPlaster : material;
  const LinearRgb paint = paint_reflectance({byte_of(red), byte_of(green), byte_of(blue)});
  const LinearRgb darker = {kMinShownShare * paint[0], kMinShownShare * paint[1], kMinShownShare * paint[2]};
  const Material chosen = tintable_material(darker, {base, materials::light_variant_of(material)});
  return {chosen, tint_towards(chosen, paint)};
}

std::vector<SurfaceMaterial> surfaces_of(const grammars::Derivation& derivation) {
  std::vector<SurfaceMaterial> surfaces;
  for (const grammars::Appearance& appearance : derivation.appearances)
    surfaces.push_back(surface_material_of(appearance));
  return surfaces;
}

std::vector<MaterialMesh> meshes_of(const FacesBySurface& faces_of, OsmId feature, double tolerance_m) {
  std::vector<MaterialMesh> meshes;
  for (const auto& [surface, faces] : faces_of) {
    MaterialMesh blank{{}, surface.material, surface.tint, feature};
    std::array<MaterialMesh, 2> made{blank, blank};
    if (surface.material == Material::kRailing && has_detail(Detail::kRailingBars, tolerance_m))
      add_bars(faces, made[0]);
    else
      made = textured_and_plain(blank, faces, tolerance_m);
    for (MaterialMesh& mesh : made)
      if (!mesh.mesh.triangles.empty()) meshes.push_back(std::move(mesh));
  }
  return meshes;
}

FacesBySurface faces_by_surface(const grammars::Derivation& derivation) {
  FacesBySurface faces_of;
  std::vector<std::vector<DerivedFace>*> of_appearance;
  for (const grammars::Appearance& appearance : derivation.appearances)
    of_appearance.push_back(&faces_of[surface_material_of(appearance)]);
  for (const grammars::Terminal& terminal : derivation.terminals)
    for (const Face& face : terminal.element == 0 ? std::span(terminal.faces) : std::span<const Face>())
      of_appearance[terminal.appearance]->push_back({face, terminal.detail_distance_m});
  return faces_of;
}

std::vector<MaterialMesh> terminal_meshes(const grammars::Derivation& derivation, OsmId feature, double tolerance_m) {
  FacesBySurface faces_of = faces_by_surface(derivation);
  for (auto& [surface, faces] : faces_of) faces = join_rectangles(std::move(faces));
  return meshes_of(faces_of, feature, tolerance_m);
}

}  // namespace citykiln::buildings
