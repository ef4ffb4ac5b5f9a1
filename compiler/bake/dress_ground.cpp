#include "compiler/bake/dress_ground.h"

#include <algorithm>
#include <optional>

#include "compiler/contract/draw.h"
#include "compiler/roads/sheet_layout.h"

namespace citykiln::bake {
namespace {

using ground::kNoSurface;
using ground::Surface;
using materials::DressedMesh;

// What is paved is one surface, whatever ways it was mapped as.
bool is_paved(map::SurfaceClass surface) {
  using map::SurfaceGroup;
  const SurfaceGroup group = map::values_of(surface).group;
  return group == SurfaceGroup::kRoad || group == SurfaceGroup::kPath || group == SurfaceGroup::kRail ||
         group == SurfaceGroup::kPaved;
}

// Brightness drawn for a surface, within its material's variation.
materials::Tint tint_of(const Surface& surface, materials::Material material, std::uint64_t seed) {
  if (is_paved(surface.surface)) return materials::kNoTint;
  const double darker = values_of(material).variation * Draw(seed, stable_id(surface.id), "ground tint").unit(0);
  const auto level = static_cast<std::uint8_t>(255 * (1 - darker) + 0.5);
  return {level, level, level, 255};
}

// The piece that a surface is, or null.
const roads::Piece* piece_of(const scene::GroundCover& cover, std::uint32_t surface) {
  if (surface == kNoSurface || cover.surfaces[surface].piece == 0) return nullptr;
  return &cover.pieces[cover.surfaces[surface].piece - 1];
}

// Faces of one mesh are those of one surface, or of one run of a road's pieces.
struct MeshOf {
  bool is_run;
  std::uint32_t number;
  auto operator<=>(const MeshOf&) const = default;
};
MeshOf mesh_of(const scene::GroundCover& cover, std::uint32_t surface) {
  const roads::Piece* piece = piece_of(cover, surface);
  return piece ? MeshOf{true, piece->run} : MeshOf{false, surface};
}

const Column* column_of(const Markings& markings, const roads::Piece* piece) {
  if (!piece || piece->pattern == roads::kNoPattern) return nullptr;
  const Column& column = markings.columns[piece->pattern];
  return column.left_m < 0 ? nullptr : &column;
}

Vec2 on_sheet(const Column& column, Vec2 uv) {
  if (column.is_turned) uv = {column.width_m - uv.x, column.length_m - uv.y};
  return {column.left_m + uv.x, uv.y};
}

// On the sheet, or across and along the road where the piece is not marked.
Vec2 uv_of(const roads::Piece& piece, const Column* column, Vec2 p) {
  const Vec2 uv = roads::uv_at(piece.frame, p);
  return column ? on_sheet(*column, uv) : uv;
}

DressedMesh dressed_as(const scene::GroundCover& cover, const Markings& markings, std::uint32_t number,
                       std::uint64_t seed) {
  DressedMesh mesh;
  const bool is_bare = number == kNoSurface;
  mesh.material = values_of(is_bare ? map::SurfaceClass::kUnknown : cover.surfaces[number].surface).material;
  if (is_bare) return mesh;
  mesh.tint = tint_of(cover.surfaces[number], mesh.material, seed);
  mesh.feature = cover.surfaces[number].id.osm;
  mesh.is_on_sheet = column_of(markings, piece_of(cover, number)) != nullptr;
  return mesh;
}

// Where the ground's vertices are in the meshes made of it.
struct Places {
  static constexpr std::uint32_t kNowhere = 0xffffffffu;
  std::vector<std::uint32_t> mesh, vertex;
  explicit Places(std::size_t count) : mesh(count, kNowhere), vertex(count, 0) {}
};

// The mesh's vertex for one of the ground's, with this uv: the one it has, or a new one.
std::uint32_t vertex_in(DressedMesh& dressed, std::uint32_t mesh, const ground::GroundMesh& ground, std::uint32_t v,
                        const std::optional<Vec2>& uv, Places& places) {
  const bool is_known = places.mesh[v] == mesh && (!uv || dressed.uvs[places.vertex[v]] == *uv);
  if (is_known) return places.vertex[v];
  places.mesh[v] = mesh;
  places.vertex[v] = static_cast<std::uint32_t>(dressed.mesh.positions.size());
  dressed.mesh.positions.push_back(ground.mesh.positions[v]);
  dressed.mesh.normals.push_back(ground.mesh.normals[v]);
  if (uv) dressed.uvs.push_back(*uv);
  return places.vertex[v];
}

std::vector<std::uint32_t> faces_by_mesh(const ground::GroundMesh& ground, const scene::GroundCover& cover) {
  std::vector<std::uint32_t> order(ground.face_surface.size());
  for (std::uint32_t f = 0; f < order.size(); ++f) order[f] = f;
  std::ranges::stable_sort(order, {}, [&](std::uint32_t f) { return mesh_of(cover, ground.face_surface[f]); });
  return order;
}

}  // namespace

Markings lay_out_markings(const scene::GroundCover& cover, double tolerance_m) {
  std::vector<roads::CanonicalPattern> drawn;
  std::vector<roads::Pattern> unique;
  for (const roads::Pattern& pattern : cover.patterns) {
    drawn.push_back(roads::canonical(pattern));
    unique.push_back(drawn.back().pattern);
  }
  std::ranges::sort(unique);
  unique.erase(std::unique(unique.begin(), unique.end()), unique.end());
  roads::SheetLayout layout = roads::lay_out(unique, tolerance_m);
  Markings markings{std::move(layout.sheet), {}};
  for (const roads::CanonicalPattern& d : drawn) {
    const auto place = std::ranges::lower_bound(unique, d.pattern) - unique.begin();
    markings.columns.push_back({layout.left_m[static_cast<std::size_t>(place)], d.is_turned, roads::width_m(d.pattern),
                                roads::length_m(d.pattern)});
  }
  return markings;
}

void put_on_sheet(const Column& column, DressedMesh& mesh) {
  if (column.left_m < 0) return;
  mesh.is_on_sheet = true;
  for (Vec2& uv : mesh.uvs) uv = on_sheet(column, uv);
}

std::vector<DressedMesh> dress(const ground::GroundMesh& ground, const scene::GroundCover& cover,
                               const Markings& markings, std::uint64_t seed) {
  std::vector<DressedMesh> dressed;
  Places places(ground.mesh.positions.size());
  std::uint32_t last = 0;
  for (const std::uint32_t f : faces_by_mesh(ground, cover)) {
    const std::uint32_t number = ground.face_surface[f];
    if (dressed.empty() || mesh_of(cover, last) != mesh_of(cover, number))
      dressed.push_back(dressed_as(cover, markings, number, seed));
    last = number;
    const roads::Piece* piece = piece_of(cover, number);
    const Column* column = column_of(markings, piece);
    Triangle triangle = ground.mesh.triangles[f];
    for (std::uint32_t& v : triangle) {
      std::optional<Vec2> uv;
      if (piece) uv = uv_of(*piece, column, in_plan(ground.mesh.positions[v]));
      v = vertex_in(dressed.back(), static_cast<std::uint32_t>(dressed.size()), ground, v, uv, places);
    }
    dressed.back().mesh.triangles.push_back(triangle);
  }
  return dressed;
}

}  // namespace citykiln::bake
