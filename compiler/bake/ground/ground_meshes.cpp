#include "compiler/bake/ground/ground_meshes.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <numeric>
#include <optional>

#include "compiler/bake/ground/border_tint.h"
#include "compiler/bake/ground/dry_ground.h"
#include "compiler/bake/ground/ground_material.h"
#include "compiler/bake/ground/ground_tint.h"
#include "compiler/bake/ground/ground_uvs.h"
#include "compiler/bake/ground/wild_cover.h"
#include "compiler/bake/merge.h"
#include "compiler/contract/erase_repeated.h"
#include "compiler/materials/texture.h"
#include "compiler/plants/species_mix.h"
#include "compiler/roads/markings/marking_atlas.h"

namespace citykiln::bake {
namespace {

using ground::kNoLandCover;
using materials::Material;
using materials::MaterialMesh;

// The inputs of a cell's material meshes.
struct CellContext {
  const ground::GroundMesh& ground;
  const scene::LandCover& cover;
  const Markings& markings;
  const scene::Header& header;
  double tolerance_m;
  plants::Month month = month_of(header);
  climate::LocalMonth local_month = local_month_of(header);
  bool is_dry = ground::is_dry_anywhere(header.climate, local_month);
  BorderTints border = border_tints(ground, cover.surfaces, header.seed, month);
};

// The piece of a road that a surface is, or null.
const roads::Piece* piece_of(const scene::LandCover& cover, std::uint32_t surface) {
  if (surface == kNoLandCover || cover.surfaces[surface].piece == 0) return nullptr;
  return &cover.pieces[cover.surfaces[surface].piece - 1];
}

map::LandCoverClass class_of(const scene::LandCover& cover, std::uint32_t surface) {
  return surface == kNoLandCover ? map::LandCoverClass::kUnknown : cover.surfaces[surface].surface;
}

// The key of a mesh: one surface, or one run of a road's pieces; one material and one layer.
struct MeshKey {
  bool is_run;
  std::uint32_t number;
  Material material;
  Layer layer;
  auto operator<=>(const MeshKey&) const = default;
};
MeshKey mesh_key(const scene::LandCover& cover, std::uint32_t surface, Material material) {
  const roads::Piece* piece = piece_of(cover, surface);
  const Layer layer = layer_of(class_of(cover, surface));
  return piece ? MeshKey{true, piece->run, material, layer} : MeshKey{false, surface, material, layer};
}

const Column* column_of_piece(const Markings& markings, const roads::Piece* piece) {
  if (!piece || piece->layout == roads::kNoMarkingLayout) return nullptr;
  const Column& column = markings.columns[piece->layout];
  return column.left_m < 0 ? nullptr : &column;
}

Vec2 on_atlas(const Column& column, Vec2 uv) {
  if (column.is_turned) uv = {column.width_m - uv.x, column.length_m - uv.y};
  return {column.left_m + uv.x, uv.y};
}

std::vector<bool> beside_roads(const CellContext& d) {
  std::vector<bool> is_beside(d.ground.mesh.positions.size(), false);
  for (std::size_t f = 0; f < d.ground.face_cover.size(); ++f)
    if (is_paved(class_of(d.cover, d.ground.face_cover[f])))
      for (const std::uint32_t v : d.ground.mesh.triangles[f]) is_beside[v] = true;
  return is_beside;
}

ground::DryShares dry_shares_at(const CellContext& d, map::LandCoverClass cover, Vec2 at) {
  return d.is_dry ? ground::dry_shares(cover, climate_mix_at(d.header.climate, at), d.local_month)
                  : ground::DryShares{};
}

// The material of a face as wild land; empty where that is not assumed, or the face is not steep and unmapped.
std::optional<Material> wild_at(const CellContext& d, const GroundFace& face) {
  constexpr double kGentlest = kWildSlopeCosine + 0.05;  // is_wild() sways less
  const bool is_asked = d.header.has_wild_slopes && face.surface == map::LandCoverClass::kUnknown;
  if (!is_asked || face.normal.z > kGentlest) return std::nullopt;
  return wild_material(climate_mix_at(d.header.climate, in_plan(face.centre)),
                       plants::belt_m_at(d.header.origin.lat_deg, face.centre.z));
}

// The flatter one of the face's own normal and of its corners' mean, since rounding may turn slivers any way.
Vec3 slope_of(const Mesh& mesh, std::size_t face) {
  const Triangle& t = mesh.triangles[face];
  const Vec3 own = normal_of(mesh, t), smooth = unit(mesh.normals[t[0]] + mesh.normals[t[1]] + mesh.normals[t[2]]);
  return own.z < smooth.z ? smooth : own;
}

Vec3 centre_of(const Mesh& mesh, std::size_t face) {
  const Triangle& t = mesh.triangles[face];
  return (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) * (1.0 / 3);
}

// The widest street whose two lanes one texture shows, stretched, and the widest one of a single lane.
constexpr double kWidestStreet_m = 11, kWidestLane_m = 4.2;

// True for unmarked asphalt from kerb to kerb, which shows the texture of a street (on_street).
bool is_unmarked_street(const CellContext& d, std::uint32_t surface, Material material) {
  const roads::Piece* piece = piece_of(d.cover, surface);
  return piece && material == Material::kOldAsphalt && piece->frame.left_u_m == 0 &&
         piece->frame.width_m <= kWidestStreet_m && !column_of_piece(d.markings, piece) &&
         map::values_of(piece->surface).group == map::LandCoverGroup::kRoad &&
         has_texture(Material::kStreetAsphalt, d.tolerance_m);
}

std::vector<Material> materials_of_faces(const CellContext& d) {
  const std::vector<bool> is_beside = beside_roads(d);
  const Mesh& mesh = d.ground.mesh;
  std::vector<Material> all;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const Triangle& t = mesh.triangles[f];
    GroundFace face{class_of(d.cover, d.ground.face_cover[f]), slope_of(mesh, f), centre_of(mesh, f)};
    face.is_vertical = f >= d.ground.first_vertical;
    face.dry = dry_shares_at(d, face.surface, in_plan(face.centre));
    face.wild = wild_at(d, face);
    for (const std::uint32_t v : t) face.is_beside_road = face.is_beside_road || is_beside[v];
    all.push_back(material_of(face, d.header.snow_line_m, d.header.seed));
    if (is_unmarked_street(d, d.ground.face_cover[f], all.back())) all.back() = Material::kStreetAsphalt;
  }
  return all;
}

// Ground under buildings needs no texture.
bool shows_texture(const CellContext& d, std::uint32_t surface, Material material) {
  return class_of(d.cover, surface) != map::LandCoverClass::kBuilding && has_texture(material, d.tolerance_m);
}

// The uvs of a face's corners, on the marking atlas or on its material's texture.
using FaceUvs = std::array<Vec2, 3>;

template <typename UvAt>
FaceUvs each_corner(const CellContext& d, std::uint32_t face, UvAt uv_at) {
  const Triangle& t = d.ground.mesh.triangles[face];
  const auto at = [&](std::size_t i) { return uv_at(d.ground.mesh.positions[t[i]]); };
  return {at(0), at(1), at(2)};
}

FaceUvs minus(FaceUvs uvs, Vec2 off) { return {uvs[0] - off, uvs[1] - off, uvs[2] - off}; }

// The whole cell subtracts the same periods, so that its faces share vertices.
FaceUvs uvs_on_land(const CellContext& d, std::uint32_t face, Material material) {
  const std::uint32_t surface = d.ground.face_cover[face];
  const Vec2 east =
      surface == kNoLandCover ? Vec2{1, 0} : texture_direction(d.cover.surfaces[surface], material, d.header.seed);
  const FaceUvs of_face = each_corner(d, face, [&](Vec3 p) { return uv_on_land(in_plan(p), east); });
  return minus(of_face, periods_below_cell(in_plan(centre_of(d.ground.mesh, face)), east));
}

// Stretches u so that the texture's lanes are those of a piece: both, or the left one on a street of one lane.
Vec2 on_street(const roads::PieceFrame& frame, Vec2 uv) {
  const double side_m = materials::texture_side_m(Material::kStreetAsphalt);
  const double shown_m = frame.width_m > kWidestLane_m ? side_m : side_m / 2;
  return frame.width_m > 0 ? Vec2{uv.x * shown_m / frame.width_m, uv.y} : uv;
}

FaceUvs uvs_on_piece(const CellContext& d, std::uint32_t face, const roads::PieceFrame& frame, Material material) {
  const bool is_street = material == Material::kStreetAsphalt;
  const FaceUvs along = each_corner(d, face, [&](Vec3 p) {
    const Vec2 uv = roads::uv_at(frame, in_plan(p));
    return on_grid(is_street ? on_street(frame, uv) : uv);
  });
  return minus(along, periods_below(along));
}

// Nothing where the face shows neither the marking atlas nor a texture.
std::optional<FaceUvs> uvs_of(const CellContext& d, std::uint32_t face, Material material) {
  const std::uint32_t surface = d.ground.face_cover[face];
  const roads::Piece* piece = piece_of(d.cover, surface);
  if (const Column* column = column_of_piece(d.markings, piece))
    return each_corner(d, face, [&](Vec3 p) { return on_atlas(*column, roads::uv_at(piece->frame, in_plan(p))); });
  if (piece) return uvs_on_piece(d, face, piece->frame, material);
  if (!shows_texture(d, surface, material)) return std::nullopt;
  const Vec3 normal = slope_of(d.ground.mesh, face);
  if (normal.z >= kSteepCosine) return uvs_on_land(d, face, material);
  const FaceUvs on_wall = each_corner(d, face, [&](Vec3 p) { return uv_on_wall(p, normal); });
  return minus(on_wall, periods_below(on_wall));
}

materials::Tint tint_at(const CellContext& d, std::uint32_t surface, Material material, std::uint32_t v) {
  const Vec2 place = in_plan(d.ground.mesh.positions[v]);
  TintFactor tint;
  if (surface != kNoLandCover) tint = surface_tint(d.cover.surfaces[surface], material, d.header.seed, d.month);
  if (d.border.is_shared[v] && has_soft_border(class_of(d.cover, surface))) tint = d.border.tints[v];
  if (material == Material::kDryGround || material == Material::kDryGrass) {
    const map::LandCoverClass cover = class_of(d.cover, surface);
    tint = times(tint, dry_tint(cover, dry_shares_at(d, cover, place)));
  }
  return tint_of(tint, place_tint(place, material, d.header.seed));
}

LayeredMesh empty_mesh(const CellContext& d, std::uint32_t surface, Material material) {
  LayeredMesh part{{}, layer_of(class_of(d.cover, surface))};
  MaterialMesh& mesh = part.mesh;
  mesh.material = material;
  if (surface == kNoLandCover) return part;
  mesh.feature = d.cover.surfaces[surface].id.osm;
  if (column_of_piece(d.markings, piece_of(d.cover, surface)))
    mesh.colour_source = materials::ColourSource::kByMarkingAtlas;
  return part;
}

// The ground's vertices in the meshes made of it.
struct VertexMap {
  static constexpr std::uint32_t kNowhere = 0xffffffffu;
  std::vector<std::uint32_t> mesh, vertex;
  explicit VertexMap(std::size_t count) : mesh(count, kNowhere), vertex(count, 0) {}
};

// The last mesh's vertex for a vertex of the ground with a uv: the one it has, or a new one.
std::uint32_t vertex_in(std::vector<LayeredMesh>& all, const CellContext& d, std::uint32_t surface, std::uint32_t v,
                        const std::optional<Vec2>& uv, VertexMap& map) {
  MaterialMesh& mesh = all.back().mesh;
  const auto number = static_cast<std::uint32_t>(all.size());
  if (map.mesh[v] == number && (!uv || mesh.uvs[map.vertex[v]] == *uv)) return map.vertex[v];
  map.mesh[v] = number;
  map.vertex[v] = static_cast<std::uint32_t>(mesh.mesh.positions.size());
  mesh.mesh.positions.push_back(d.ground.mesh.positions[v]);
  mesh.mesh.normals.push_back(d.ground.mesh.normals[v]);
  mesh.tints.push_back(tint_at(d, surface, mesh.material, v));
  if (uv) mesh.uvs.push_back(*uv);
  return map.vertex[v];
}

void add_ground_face(std::vector<LayeredMesh>& all, const CellContext& d, std::uint32_t face, VertexMap& map) {
  const std::optional<FaceUvs> uvs = uvs_of(d, face, all.back().mesh.material);
  Triangle triangle = d.ground.mesh.triangles[face];
  for (std::size_t i = 0; i < 3; ++i) {
    std::optional<Vec2> uv;
    if (uvs) uv = (*uvs)[i];
    triangle[i] = vertex_in(all, d, d.ground.face_cover[face], triangle[i], uv, map);
  }
  all.back().mesh.mesh.triangles.push_back(triangle);
}

}  // namespace

Markings lay_out_markings(std::span<const roads::MarkingLayout> layouts, double tolerance_m) {
  Markings markings;
  for (const roads::MarkingLayout& layout : layouts) markings.drawn.push_back(roads::canonical_layout(layout).layout);
  sort_unique(markings.drawn);
  roads::MarkingAtlas atlas = roads::make_marking_atlas(markings.drawn, tolerance_m);
  markings.atlas = std::move(atlas.image), markings.left_m = std::move(atlas.left_m);
  for (const roads::MarkingLayout& layout : layouts) markings.columns.push_back(column_of(markings, layout));
  return markings;
}

Column column_of(const Markings& markings, const roads::MarkingLayout& layout) {
  const auto [like, is_turned] = roads::canonical_layout(layout);
  const auto place = std::ranges::lower_bound(markings.drawn, like);
  assert(place != markings.drawn.end() && *place == like);
  return {markings.left_m[static_cast<std::size_t>(place - markings.drawn.begin())], is_turned, roads::width_m(like),
          roads::length_m(like)};
}

void map_to_atlas(const Column& column, MaterialMesh& mesh) {
  if (column.left_m < 0) return;
  mesh.colour_source = materials::ColourSource::kByMarkingAtlas;
  for (Vec2& uv : mesh.uvs) uv = on_atlas(column, uv);
}

std::vector<LayeredMesh> material_meshes(const ground::GroundMesh& ground, const scene::LandCover& cover,
                                         const Markings& markings, const scene::Header& header, double tolerance_m) {
  assert(ground.face_cover.size() == ground.mesh.triangles.size() && markings.columns.size() >= cover.layouts.size());
  const CellContext d{ground, cover, markings, header, tolerance_m};
  const std::vector<Material> materials = materials_of_faces(d);
  const auto key_of_face = [&](std::uint32_t f) { return mesh_key(cover, ground.face_cover[f], materials[f]); };
  std::vector<std::uint32_t> order(ground.face_cover.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order, {}, key_of_face);

  std::vector<LayeredMesh> meshes;
  VertexMap map(ground.mesh.positions.size());
  std::optional<MeshKey> last;
  for (const std::uint32_t f : order) {
    if (last != key_of_face(f)) meshes.push_back(empty_mesh(d, ground.face_cover[f], materials[f]));
    last = key_of_face(f);
    add_ground_face(meshes, d, f, map);
  }
  return meshes;
}

}  // namespace citykiln::bake
