#include "compiler/surroundings/generate.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <map>
#include <utility>

#include "compiler/geometry/snap.h"
#include "compiler/surroundings/curvature.h"

namespace citykiln::surroundings {
namespace {

using materials::Material;
using materials::MaterialMesh;

constexpr double kHeightStep_m = 0x1p-7;

// A triangle, and whether it hangs from the border.
struct Face {
  Triangle corners;
  bool is_skirt = false;
};

// The surface before it is divided by material.
struct Sheet {
  std::vector<Vec3> positions, normals;
  std::vector<bool> is_sea;
  std::vector<Face> faces;
};

class SheetBuilder {
 public:
  SheetBuilder(const Surroundings& around, const Neighbourhood& neighbourhood)
      : around_(around), neighbourhood_(neighbourhood), in_tile_((around.columns() - 1) * (around.rows() - 1)) {
    for (std::size_t j = 0; j + 1 < around.rows(); ++j)
      for (std::size_t i = 0; i + 1 < around.columns(); ++i)
        in_tile_[cell(i, j)] = neighbourhood.is_in_tile((around.vertex(i, j) + around.vertex(i + 1, j + 1)) * 0.5);
  }

  Sheet build() {
    for (std::size_t j = 0; j + 1 < around_.rows(); ++j)
      for (std::size_t i = 0; i + 1 < around_.columns(); ++i)
        if (!in_tile_[cell(i, j)]) add_cell(i, j);
    add_normals();
    return std::move(sheet_);
  }

 private:
  std::size_t cell(std::size_t i, std::size_t j) const { return j * (around_.columns() - 1) + i; }

  // @param i, j  -1 and the number of cells lie outside of the grid.
  bool is_tile(std::ptrdiff_t i, std::ptrdiff_t j) const {
    const auto columns = static_cast<std::ptrdiff_t>(around_.columns()) - 1;
    const auto rows = static_cast<std::ptrdiff_t>(around_.rows()) - 1;
    return i >= 0 && j >= 0 && i < columns && j < rows &&
           in_tile_[cell(static_cast<std::size_t>(i), static_cast<std::size_t>(j))];
  }

  bool is_on_border(std::size_t i, std::size_t j) const {
    const auto x = static_cast<std::ptrdiff_t>(i), y = static_cast<std::ptrdiff_t>(j);
    return is_tile(x, y) || is_tile(x - 1, y) || is_tile(x, y - 1) || is_tile(x - 1, y - 1);
  }

  double lowered_m(Vec2 place) const {
    return neighbourhood_.is_curved ? drop_m(away_m(neighbourhood_.extent, place)) : 0;
  }

  std::uint32_t add_vertex(Vec2 place, double height_m, bool is_sea) {
    const double z = height_m - lowered_m(place);
    sheet_.positions.push_back(at_height(place, std::floor(z / kHeightStep_m + 0.5) * kHeightStep_m));
    sheet_.is_sea.push_back(is_sea);
    return static_cast<std::uint32_t>(sheet_.positions.size() - 1);
  }

  std::uint32_t border_vertex(Vec2 place) {
    const auto [known, is_new] = on_border_.try_emplace({place.x, place.y});
    if (!is_new) return known->second;
    const BorderGround ground = neighbourhood_.on_border(place);
    return known->second = add_vertex(place, ground.height_m, ground.is_sea);
  }

  std::uint32_t grid_vertex(std::size_t i, std::size_t j) {
    if (is_on_border(i, j)) return border_vertex(around_.vertex(i, j));
    const auto [known, is_new] = in_grid_.try_emplace(around_.index(i, j));
    if (!is_new) return known->second;
    const std::size_t at = around_.index(i, j);
    const bool is_sea = around_.covers[at] == Cover::kSea;
    return known->second = add_vertex(around_.vertex(i, j), around_.heights_m[at], is_sea);
  }

  void add_cell(std::size_t i, std::size_t j) {
    const auto x = static_cast<std::ptrdiff_t>(i), y = static_cast<std::ptrdiff_t>(j);
    // south, east, north, west; corners from the south-western one on
    const std::array<bool, 4> borders = {is_tile(x, y - 1), is_tile(x + 1, y), is_tile(x, y + 1), is_tile(x - 1, y)};
    const std::array<std::uint32_t, 4> corners = {grid_vertex(i, j), grid_vertex(i + 1, j), grid_vertex(i + 1, j + 1),
                                                  grid_vertex(i, j + 1)};
    if (std::ranges::find(borders, true) == borders.end()) {
      sheet_.faces.push_back({{corners[0], corners[1], corners[2]}});
      sheet_.faces.push_back({{corners[0], corners[2], corners[3]}});
      return;
    }
    add_fan(corners, borders);
  }

  // The vertices of a side on the border, its ends included.
  std::vector<std::uint32_t> along(std::uint32_t from, std::uint32_t to) {
    const Vec2 a = in_plan(sheet_.positions[from]), b = in_plan(sheet_.positions[to]);
    const int parts = std::max(1, static_cast<int>(std::ceil(distance(a, b) / kBorderStep_m)));
    std::vector<std::uint32_t> all = {from};
    for (int part = 1; part < parts; ++part)
      all.push_back(border_vertex(snapped_to(kHeightStep_m, a + (b - a) * (static_cast<double>(part) / parts))));
    all.push_back(to);
    return all;
  }

  void add_fan(const std::array<std::uint32_t, 4>& corners, const std::array<bool, 4>& borders) {
    double height_m = 0;
    bool is_sea = true;
    for (const std::uint32_t corner : corners) {
      const Vec3 at = sheet_.positions[corner];
      height_m += (at.z + lowered_m(in_plan(at))) / 4;
      is_sea = is_sea && sheet_.is_sea[corner];
    }
    const Vec2 middle = (in_plan(sheet_.positions[corners[0]]) + in_plan(sheet_.positions[corners[2]])) * 0.5;
    const std::uint32_t centre = add_vertex(middle, is_sea ? 0 : height_m, is_sea);
    for (std::size_t side = 0; side < 4; ++side) {
      const std::uint32_t from = corners[side], to = corners[(side + 1) % 4];
      const std::vector<std::uint32_t> all = borders[side] ? along(from, to) : std::vector{from, to};
      for (std::size_t k = 0; k + 1 < all.size(); ++k) {
        sheet_.faces.push_back({{centre, all[k], all[k + 1]}});
        if (borders[side]) add_skirt(all[k], all[k + 1]);
      }
    }
  }

  // Faces the tile: the mesh lies to the left of a → b.
  void add_skirt(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t low_a = below(a), low_b = below(b);
    sheet_.faces.push_back({{a, low_a, low_b}, true});
    sheet_.faces.push_back({{a, low_b, b}, true});
  }

  std::uint32_t below(std::uint32_t vertex) {
    const auto [known, is_new] = below_.try_emplace(vertex);
    if (!is_new) return known->second;
    sheet_.positions.push_back(sheet_.positions[vertex] - Vec3{0, 0, kSkirt_m});
    sheet_.is_sea.push_back(sheet_.is_sea[vertex]);
    return known->second = static_cast<std::uint32_t>(sheet_.positions.size() - 1);
  }

  // Means of the faces about a vertex, by their area. A skirt looks as the ground above it.
  void add_normals() {
    sheet_.normals.assign(sheet_.positions.size(), {});
    for (const auto& [corners, is_skirt] : sheet_.faces) {
      if (is_skirt) continue;
      const Vec3 a = sheet_.positions[corners[0]];
      const Vec3 normal = cross(sheet_.positions[corners[1]] - a, sheet_.positions[corners[2]] - a);
      for (const std::uint32_t corner : corners) sheet_.normals[corner] = sheet_.normals[corner] + normal;
    }
    for (const auto& [above, low] : below_) sheet_.normals[low] = sheet_.normals[above];
    for (Vec3& normal : sheet_.normals) normal = unit(normal);
  }

  const Surroundings& around_;
  const Neighbourhood& neighbourhood_;
  std::vector<bool> in_tile_;
  std::map<std::pair<double, double>, std::uint32_t> on_border_;  // vertices by place
  std::map<std::size_t, std::uint32_t> in_grid_;                  // by index in the grid
  std::map<std::uint32_t, std::uint32_t> below_;                  // by the vertex above
  Sheet sheet_;
};

// Divides a sheet by material. Sea at the corner of a land face looks like land.
class Divider {
 public:
  Divider(const Sheet& sheet, const Neighbourhood& neighbourhood) : sheet_(sheet) {
    for (std::size_t i = 0; i < sheet.positions.size(); ++i)
      looks_.push_back(neighbourhood.land_at(sheet.positions[i], sheet.normals[i]));
  }

  std::vector<MaterialMesh> divide() {
    for (const Face& face : sheet_.faces) add(face.corners);
    std::vector<MaterialMesh> meshes;
    for (auto& [material, part] : parts_) meshes.push_back(std::move(part.mesh));
    return meshes;
  }

 private:
  struct Part {
    MaterialMesh mesh;
    std::map<std::uint32_t, std::uint32_t> vertices;  // by that of the sheet
  };

  // The material of most corners; of the first one on land where all differ.
  Material material_of(const Triangle& corners) const {
    const auto at = [&](std::size_t i) { return looks_[corners[i]].material; };
    const auto on_land = [&](std::size_t i) { return !sheet_.is_sea[corners[i]]; };
    if (!on_land(0) && !on_land(1) && !on_land(2)) return Material::kSea;
    if (on_land(1) && at(1) == at(2)) return at(1);
    return on_land(0) ? at(0) : on_land(1) ? at(1) : at(2);
  }

  void add(const Triangle& corners) {
    const Material material = material_of(corners);
    Part& part = parts_[material];
    part.mesh.material = material;
    Triangle own{};
    for (std::size_t i = 0; i < 3; ++i) own[i] = vertex(part, corners[i]);
    part.mesh.mesh.triangles.push_back(own);
  }

  std::uint32_t vertex(Part& part, std::uint32_t of_sheet) {
    const auto next = static_cast<std::uint32_t>(part.mesh.mesh.positions.size());
    const auto [known, is_new] = part.vertices.try_emplace(of_sheet, next);
    if (!is_new) return known->second;
    const materials::SurfaceMaterial& look = looks_[of_sheet];
    part.mesh.mesh.positions.push_back(sheet_.positions[of_sheet]);
    part.mesh.mesh.normals.push_back(sheet_.normals[of_sheet]);
    part.mesh.tints.push_back(look.material == part.mesh.material ? look.tint : materials::kNoTint);
    return next;
  }

  const Sheet& sheet_;
  std::vector<materials::SurfaceMaterial> looks_;  // of land, one per vertex
  std::map<Material, Part> parts_;
};

}  // namespace

std::vector<MaterialMesh> generate(const Surroundings& around, const Neighbourhood& neighbourhood) {
  assert(!around.is_empty() && is_sound(around));
  const Sheet sheet = SheetBuilder(around, neighbourhood).build();
  return Divider(sheet, neighbourhood).divide();
}

}  // namespace citykiln::surroundings
