#include "compiler/surroundings/generate.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <map>
#include <utility>

#include "compiler/geometry/snap.h"
#include "compiler/materials/noise.h"
#include "compiler/surroundings/curvature.h"
#include "compiler/surroundings/grid_lines.h"

namespace citykiln::surroundings {
namespace {

using materials::Material;
using materials::MaterialMesh;

constexpr double kHeightStep_m = 0x1p-7;
// The distance by which vertices between cells leave the lattice, as a share of the smallest cell, so that fields and
// woods have no steps.
constexpr double kJitter = 0.22;
// Canopies are higher and lower by up to this share of the wood's height, in places.
constexpr double kUneven = 0.3;
// The height of the middle of a cell at the edge of a wood, as a share of the wood's.
constexpr double kEdgeMiddle = 0.85;
// Places along a side of a box at which it is searched for land.
constexpr int kSeaPlaces = 5;
// Land is rough where its middle is farther from its corners' mean than this share of the distance.
constexpr double kRough = 0.006;

double lowered_m(const Neighbourhood& neighbourhood, Vec2 place) {
  return neighbourhood.is_curved ? drop_m(away_m(neighbourhood.extent, place)) : 0;
}

bool is_rough(const Neighbourhood& neighbourhood, const Box2& box) {
  const Vec2 low = box.min, high = box.max, middle = box.centre();
  const auto height_m = [&](double x, double y) { return neighbourhood.height_m_at({x, y}); };
  const double mean_m =
      (height_m(low.x, low.y) + height_m(high.x, low.y) + height_m(high.x, high.y) + height_m(low.x, high.y)) / 4;
  return std::abs(height_m(middle.x, middle.y) - mean_m) > kRough * neighbourhood.away_m(box);
}

// Open water at places all over a box, those on its sides included.
bool is_all_water(const Surroundings& around, const Box2& box) {
  for (int y = 0; y < kSeaPlaces; ++y)
    for (int x = 0; x < kSeaPlaces; ++x) {
      const Vec2 share{static_cast<double>(x) / (kSeaPlaces - 1), static_cast<double>(y) / (kSeaPlaces - 1)};
      const Vec2 place = box.min + Vec2{box.width() * share.x, box.height() * share.y};
      if (!is_open_water(cover_at(around, place))) return false;
    }
  return true;
}

std::vector<Cell> cells_outside(const Surroundings& around, const Neighbourhood& neighbourhood) {
  std::vector<Cell> cells =
      cells_over(around.box(), {.finest_m = neighbourhood.finest_m,
                                .away_m = neighbourhood.away_m,
                                .is_rough = [&](const Box2& box) { return is_rough(neighbourhood, box); },
                                .is_sea = [&](const Box2& box) { return is_all_water(around, box); }});
  std::erase_if(cells, [&](const Cell& cell) { return neighbourhood.is_in_tile(cell.box().centre()); });
  return cells;
}

double cross_of(Vec2 a, Vec2 b, Vec2 p) { return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x); }

// The height of a triangle at a place of the plane; empty beside it.
std::optional<double> height_in(const std::array<Vec3, 3>& t, Vec2 p) {
  const double area = cross_of(in_plan(t[0]), in_plan(t[1]), in_plan(t[2]));
  if (area <= 0) return std::nullopt;
  const double a = cross_of(in_plan(t[1]), in_plan(t[2]), p), b = cross_of(in_plan(t[2]), in_plan(t[0]), p),
               c = cross_of(in_plan(t[0]), in_plan(t[1]), p);
  const double least = -1e-9 * area;
  if (a < least || b < least || c < least) return std::nullopt;
  return (t[0].z * a + t[1].z * b + t[2].z * c) / area;
}

}  // namespace

// The surface before it is divided by material.
struct AroundSurface::Sheet {
  enum class FaceKind : std::uint8_t { kGround, kSkirt, kCanopy };
  struct Face {
    Triangle corners;
    std::uint32_t patch = 0;  // the number of its cell
    FaceKind kind{};
  };

  std::vector<Cell> cells;
  CellIndex index;
  std::vector<Patch> patches;  // one per cell
  std::vector<Vec3> positions, normals;
  std::vector<Cover> covers;
  std::vector<bool> is_on_border;
  std::vector<Face> faces;
  std::vector<std::uint32_t> first_face;  // by cell, and the end; ground first
};

namespace {

// Builds a sheet: a fan or two triangles for each cell.
template <typename Sheet>
class SheetBuilder {
 public:
  SheetBuilder(const Surroundings& around, const Neighbourhood& neighbourhood, Sheet& sheet)
      : around_(around), neighbourhood_(neighbourhood), sheet_(sheet) {}

  void build() {
    for (const Cell& cell : sheet_.cells) {
      sheet_.patches.push_back(neighbourhood_.patch_of(cell));
      for (const std::int32_t y : {cell.y_m, cell.y_m + cell.side_m})
        for (const std::int32_t x : {cell.x_m, cell.x_m + cell.side_m}) {
          std::int32_t& side_m = smallest_.try_emplace({x, y}, cell.side_m).first->second;
          side_m = std::min(side_m, cell.side_m);
        }
    }
    for (std::uint32_t i = 0; i < sheet_.cells.size(); ++i) {
      sheet_.first_face.push_back(static_cast<std::uint32_t>(sheet_.faces.size()));
      add_cell(i);
    }
    sheet_.first_face.push_back(static_cast<std::uint32_t>(sheet_.faces.size()));
    add_normals();
  }

 private:
  using Face = typename Sheet::Face;
  using FaceKind = typename Sheet::FaceKind;
  using Place = std::pair<std::int32_t, std::int32_t>;

  struct Outline {
    std::vector<std::uint32_t> vertices;  // counter-clockwise from the south-western corner
    std::vector<Vec2> outside;            // of the side after each vertex: a place beyond its middle
    std::vector<bool> is_border;          // of the side after each vertex
  };

  std::uint32_t add_vertex(Vec2 place, double height_m, Cover cover) {
    const double z = height_m - lowered_m(neighbourhood_, place);
    sheet_.positions.push_back(at_height(place, std::floor(z / kHeightStep_m + 0.5) * kHeightStep_m));
    sheet_.covers.push_back(cover), sheet_.is_on_border.push_back(false);
    return static_cast<std::uint32_t>(sheet_.positions.size() - 1);
  }

  std::uint32_t border_vertex(Place at) {
    const auto [known, is_new] = vertices_.try_emplace(at);
    if (!is_new) return known->second;
    const Vec2 place{static_cast<double>(at.first), static_cast<double>(at.second)};
    const BorderGround ground = neighbourhood_.on_border(place);
    known->second = add_vertex(place, ground.height_m, ground.cover);
    sheet_.is_on_border[known->second] = true;
    return known->second;
  }

  std::uint32_t lattice_vertex(Place at) {
    const Vec2 place{static_cast<double>(at.first), static_cast<double>(at.second)};
    if (neighbourhood_.away_m({place, place}) == 0) return border_vertex(at);
    const auto [known, is_new] = vertices_.try_emplace(at);
    if (!is_new) return known->second;
    const double reach_m = kJitter * smallest_.at(at);
    const Vec2 moved = snapped_to(
        kHeightStep_m, place + Vec2{materials::noise_at(place, 1, 1), materials::noise_at(place, 1, 2)} * reach_m);
    const Cover cover = cover_at(around_, moved);
    return known->second = add_vertex(moved, cover == Cover::kSea ? 0 : neighbourhood_.height_m_at(moved), cover);
  }

  // Adds the vertices from a on, before b: those of smaller cells on the other side.
  void add_side(Place a, Place b, std::vector<std::uint32_t>& to) {
    const Place middle{(a.first + b.first) / 2, (a.second + b.second) / 2};
    const bool is_split =
        middle != a && (a.first + b.first) % 2 == 0 && (a.second + b.second) % 2 == 0 && smallest_.contains(middle);
    if (!is_split) return to.push_back(lattice_vertex(a));
    add_side(a, middle, to), add_side(middle, b, to);
  }

  void add_border_side(Place a, Place b, std::vector<std::uint32_t>& to) {
    const std::int32_t length_m = std::abs(b.first - a.first) + std::abs(b.second - a.second);
    const int parts = std::max(1, static_cast<int>(std::ceil(length_m / kBorderStep_m)));
    for (int part = 0; part < parts; ++part)
      to.push_back(border_vertex(
          {a.first + (b.first - a.first) * part / parts, a.second + (b.second - a.second) * part / parts}));
  }

  Outline outline_of(const Cell& cell) {
    const std::int32_t s = cell.side_m;
    const std::array<Place, 4> corners = {Place{cell.x_m, cell.y_m}, Place{cell.x_m + s, cell.y_m},
                                          Place{cell.x_m + s, cell.y_m + s}, Place{cell.x_m, cell.y_m + s}};
    constexpr std::array<Vec2, 4> kOut = {Vec2{0, -1}, Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}};
    Outline outline;
    for (std::size_t side = 0; side < 4; ++side) {
      const Place a = corners[side], b = corners[(side + 1) % 4];
      const Vec2 middle = Vec2{static_cast<double>(a.first + b.first), static_cast<double>(a.second + b.second)} * 0.5;
      const bool is_border = neighbourhood_.is_in_tile(middle + kOut[side]);
      const std::size_t first = outline.vertices.size();
      is_border ? add_border_side(a, b, outline.vertices) : add_side(a, b, outline.vertices);
      const std::size_t parts = outline.vertices.size() - first;
      const Vec2 from{static_cast<double>(a.first), static_cast<double>(a.second)};
      for (std::size_t part = 0; part < parts; ++part)
        outline.outside.push_back(from + (middle - from) * (2 * (part + 0.5) / parts) + kOut[side]);
      outline.is_border.insert(outline.is_border.end(), parts, is_border);
    }
    return outline;
  }

  void add_cell(std::uint32_t cell) {
    const Outline outline = outline_of(sheet_.cells[cell]);
    const std::vector<std::uint32_t>& v = outline.vertices;
    if (v.size() == 4) {
      sheet_.faces.push_back({{v[0], v[1], v[2]}, cell, FaceKind::kGround});
      sheet_.faces.push_back({{v[0], v[2], v[3]}, cell, FaceKind::kGround});
    } else {
      add_fan(cell, outline);
    }
    for (std::size_t k = 0; k < v.size(); ++k)
      if (outline.is_border[k]) add_skirt(cell, v[k], v[(k + 1) % v.size()]);
    if (sheet_.patches[cell].raised_m > 0) add_canopy(cell, outline);
  }

  void add_fan(std::uint32_t cell, const Outline& outline) {
    const std::vector<std::uint32_t>& v = outline.vertices;
    double height_m = 0;
    bool is_one_cover = true;
    const Cover cover = sheet_.covers[v.front()];
    Vec2 middle;
    const double share = 1.0 / static_cast<double>(v.size());
    for (const std::uint32_t vertex : v) {
      const Vec3 at = sheet_.positions[vertex];
      height_m += (at.z + lowered_m(neighbourhood_, in_plan(at))) * share;
      middle = middle + in_plan(at) * share;
      is_one_cover = is_one_cover && sheet_.covers[vertex] == cover;
    }
    const bool is_sea = is_one_cover && cover == Cover::kSea;
    const std::uint32_t centre =
        add_vertex(snapped_to(kHeightStep_m, middle), is_sea ? 0 : height_m, is_one_cover ? cover : Cover::kLand);
    for (std::size_t k = 0; k < v.size(); ++k)
      sheet_.faces.push_back({{centre, v[k], v[(k + 1) % v.size()]}, cell, FaceKind::kGround});
  }

  // Faces the tile: the mesh lies to the left of a → b.
  void add_skirt(std::uint32_t cell, std::uint32_t a, std::uint32_t b) {
    const std::uint32_t low_a = below(a), low_b = below(b);
    sheet_.faces.push_back({{a, low_a, low_b}, cell, FaceKind::kSkirt});
    sheet_.faces.push_back({{a, low_b, b}, cell, FaceKind::kSkirt});
  }

  std::uint32_t below(std::uint32_t vertex) {
    const auto [known, is_new] = below_.try_emplace(vertex);
    if (!is_new) return known->second;
    known->second = add_copy(vertex, -kSkirt_m);
    sheet_.is_on_border[known->second] = true;
    return known->second;
  }

  std::uint32_t add_copy(std::uint32_t vertex, double above_m) {
    const Vec3 at = sheet_.positions[vertex];
    sheet_.positions.push_back({at.x, at.y, std::floor((at.z + above_m) / kHeightStep_m + 0.5) * kHeightStep_m});
    sheet_.covers.push_back(Cover::kLand), sheet_.is_on_border.push_back(false);
    return static_cast<std::uint32_t>(sheet_.positions.size() - 1);
  }

  bool is_inside_wood(Vec2 vertex) const {
    const double aside_m = neighbourhood_.finest_m / 2.0;
    return std::ranges::all_of(std::array{Vec2{1, 1}, Vec2{1, -1}, Vec2{-1, 1}, Vec2{-1, -1}},
                               [&](Vec2 aside) { return has_canopy(vertex + aside * aside_m); });
  }

  double uneven_at(Vec2 place) const { return 1 + kUneven * materials::noise_at(place, 1, 3); }

  // A vertex of the canopy above one of the ground; that of the ground at the edge of the wood.
  std::uint32_t raised(std::uint32_t vertex, double raised_m) {
    const Vec2 at = in_plan(sheet_.positions[vertex]);
    if (!is_inside_wood(at)) return vertex;
    const auto [known, is_new] = raised_.try_emplace(vertex);
    if (!is_new) return known->second;
    return known->second = add_copy(vertex, raised_m * uneven_at(at));
  }

  bool has_canopy(Vec2 place) const {
    const std::uint32_t cell = sheet_.index.at(place);
    return cell != CellIndex::kNone && sheet_.patches.at(cell).raised_m > 0;
  }

  void add_canopy(std::uint32_t cell, const Outline& outline) {
    const std::vector<std::uint32_t>& v = outline.vertices;
    if (std::ranges::all_of(v, [&](std::uint32_t vertex) { return is_open_water(sheet_.covers[vertex]); })) return;
    const double raised_m = sheet_.patches[cell].raised_m;
    std::vector<std::uint32_t> tops;
    bool is_inside = v.size() == 4;
    for (const std::uint32_t vertex : v) {
      tops.push_back(raised(vertex, raised_m));
      is_inside = is_inside && tops.back() != vertex;
    }
    if (!is_inside) return add_canopy_fan(cell, v, tops, raised_m);
    sheet_.faces.push_back({{tops[0], tops[1], tops[2]}, cell, FaceKind::kCanopy});
    sheet_.faces.push_back({{tops[0], tops[2], tops[3]}, cell, FaceKind::kCanopy});
  }

  void add_canopy_fan(std::uint32_t cell, const std::vector<std::uint32_t>& ground,
                      const std::vector<std::uint32_t>& tops, double raised_m) {
    Vec3 middle;
    for (const std::uint32_t vertex : ground)
      middle = middle + sheet_.positions[vertex] * (1.0 / static_cast<double>(ground.size()));
    const double above_m = kEdgeMiddle * raised_m * uneven_at(in_plan(middle));
    sheet_.positions.push_back(snapped({middle.x, middle.y, middle.z + above_m}));
    sheet_.covers.push_back(Cover::kLand), sheet_.is_on_border.push_back(false);
    const auto centre = static_cast<std::uint32_t>(sheet_.positions.size() - 1);
    for (std::size_t k = 0; k < tops.size(); ++k)
      sheet_.faces.push_back({{centre, tops[k], tops[(k + 1) % tops.size()]}, cell, FaceKind::kCanopy});
  }

  // Means of the faces about a vertex, by their area. A skirt looks as the ground above it.
  void add_normals() {
    sheet_.normals.assign(sheet_.positions.size(), {});
    for (const Face& face : sheet_.faces) {
      if (face.kind == FaceKind::kSkirt) continue;
      const Vec3 a = sheet_.positions[face.corners[0]];
      const Vec3 normal = cross(sheet_.positions[face.corners[1]] - a, sheet_.positions[face.corners[2]] - a);
      for (const std::uint32_t corner : face.corners) sheet_.normals[corner] = sheet_.normals[corner] + normal;
    }
    for (const auto& [above, low] : below_) sheet_.normals[low] = sheet_.normals[above];
    for (Vec3& normal : sheet_.normals) normal = normal == Vec3{} ? Vec3{0, 0, 1} : unit(normal);
  }

  const Surroundings& around_;
  const Neighbourhood& neighbourhood_;
  Sheet& sheet_;
  std::map<Place, std::int32_t> smallest_;                 // of the corners of cells: the side of the smallest
  std::map<Place, std::uint32_t> vertices_;                // by place, before they are moved
  std::map<std::uint32_t, std::uint32_t> below_, raised_;  // by the vertex of the ground
};

// Divides a sheet by material. Water at the corner of a land face looks like land.
template <typename Sheet>
class Divider {
 public:
  Divider(const Sheet& sheet, const Neighbourhood& neighbourhood)
      : sheet_(sheet), neighbourhood_(neighbourhood), about_(sheet.positions.size()) {
    for (const Face& face : sheet.faces)
      if (is_drawn(face) && has_tint(material_of(face)))
        for (const std::uint32_t corner : face.corners) {
          std::vector<std::uint32_t>& about = about_[corner];
          if (std::ranges::find(about, face.patch) == about.end()) about.push_back(face.patch);
        }
  }

  std::vector<MaterialMesh> divide() {
    for (const Face& face : sheet_.faces)
      if (is_drawn(face)) add(face);
    std::vector<MaterialMesh> meshes;
    for (auto& [material, part] : parts_) meshes.push_back(std::move(part.mesh));
    return meshes;
  }

 private:
  using Face = typename Sheet::Face;
  using FaceKind = typename Sheet::FaceKind;
  struct Part {
    MaterialMesh mesh;
    std::map<std::uint32_t, std::uint32_t> vertices;  // by the vertex of the sheet
  };

  static bool has_tint(Material material) { return !materials::is_water(material); }

  // Canopies hide the ground below.
  bool is_drawn(const Face& face) const { return face.kind != FaceKind::kGround || !has_canopy(face); }

  bool has_canopy(const Face& face) const {
    return sheet_.patches[face.patch].raised_m > 0 && !is_open_water(cover_of(face));
  }

  // The cover of all three corners; land if they differ.
  Cover cover_of(const Face& face) const {
    const auto& [a, b, c] = face.corners;
    const Cover cover = sheet_.covers[a];
    return sheet_.covers[b] == cover && sheet_.covers[c] == cover ? cover : Cover::kLand;
  }

  Material material_of(const Face& face) const {
    const auto& [a, b, c] = face.corners;
    const bool is_ground = face.kind == FaceKind::kGround || face.kind == FaceKind::kSkirt;
    if (is_ground && cover_of(face) == Cover::kSea) return Material::kSea;
    if (is_ground && cover_of(face) == Cover::kLake) return Material::kWater;
    const Vec3 middle = (sheet_.positions[a] + sheet_.positions[b] + sheet_.positions[c]) * (1.0 / 3);
    const Vec3 normal = sheet_.normals[a] + sheet_.normals[b] + sheet_.normals[c];
    return neighbourhood_.material_at(sheet_.patches[face.patch], middle, unit(normal));
  }

  void add(const Face& face) {
    const Material material = material_of(face);
    Part& part = parts_[material];
    part.mesh.material = material;
    Triangle own{};
    for (std::size_t i = 0; i < 3; ++i) own[i] = vertex(part, face.corners[i]);
    part.mesh.mesh.triangles.push_back(own);
  }

  std::uint32_t vertex(Part& part, std::uint32_t of_sheet) {
    const auto next = static_cast<std::uint32_t>(part.mesh.mesh.positions.size());
    const auto [known, is_new] = part.vertices.try_emplace(of_sheet, next);
    if (!is_new) return known->second;
    part.mesh.mesh.positions.push_back(sheet_.positions[of_sheet]);
    part.mesh.mesh.normals.push_back(sheet_.normals[of_sheet]);
    part.mesh.tints.push_back(has_tint(part.mesh.material) ? tint_of(of_sheet, part.mesh.material)
                                                           : materials::kNoTint);
    return next;
  }

  // The mean of the cells about a vertex; on the border that of the tile.
  materials::Tint tint_of(std::uint32_t of_sheet, Material material) const {
    const Vec3 at = sheet_.positions[of_sheet], normal = sheet_.normals[of_sheet];
    if (sheet_.is_on_border[of_sheet] && neighbourhood_.patch_on_border)
      if (const std::optional<Patch> patch = neighbourhood_.patch_on_border(in_plan(at)))
        return neighbourhood_.tint_at(*patch, material, at, normal);
    const std::vector<std::uint32_t>& about = about_[of_sheet];
    std::array<std::uint32_t, 4> sum{};
    for (const std::uint32_t patch : about) {
      const materials::Tint tint = neighbourhood_.tint_at(sheet_.patches[patch], material, at, normal);
      for (std::size_t c = 0; c < 4; ++c) sum[c] += tint[c];
    }
    const auto count = static_cast<std::uint32_t>(about.size());
    materials::Tint mean{};
    for (std::size_t c = 0; c < 4; ++c) mean[c] = static_cast<std::uint8_t>((sum[c] + count / 2) / count);
    return mean;
  }

  const Sheet& sheet_;
  const Neighbourhood& neighbourhood_;
  std::vector<std::vector<std::uint32_t>> about_;  // by vertex of the sheet: the cells about it whose ground is seen
  std::map<Material, Part> parts_;
};

}  // namespace

AroundSurface::AroundSurface(const Surroundings& around, const Neighbourhood& neighbourhood)
    : around_(around), neighbourhood_(neighbourhood) {
  assert(!around.is_empty() && is_sound(around));
  std::vector<Cell> cells = cells_outside(around, neighbourhood);
  CellIndex index(cells);
  auto sheet = std::make_unique<Sheet>(Sheet{std::move(cells), std::move(index), {}, {}, {}, {}, {}, {}, {}});
  sheet->patches.reserve(sheet->cells.size());
  SheetBuilder<Sheet>(around, neighbourhood, *sheet).build();
  sheet_ = std::move(sheet);
}

AroundSurface::~AroundSurface() = default;

std::vector<MaterialMesh> AroundSurface::meshes() const { return Divider<Sheet>(*sheet_, neighbourhood_).divide(); }

std::optional<double> AroundSurface::height_m_at(Vec2 place) const {
  const auto in_cell = [&](std::uint32_t cell) -> std::optional<double> {
    for (std::uint32_t f = sheet_->first_face[cell]; f < sheet_->first_face[cell + 1]; ++f) {
      const Sheet::Face& face = sheet_->faces[f];
      if (face.kind != Sheet::FaceKind::kGround) break;
      const std::vector<Vec3>& at = sheet_->positions;
      const auto height_m = height_in({at[face.corners[0]], at[face.corners[1]], at[face.corners[2]]}, place);
      if (height_m) return height_m;
    }
    return std::nullopt;
  };
  const std::uint32_t own = sheet_->index.at(place);
  if (own != CellIndex::kNone)
    if (const auto height_m = in_cell(own)) return height_m;
  // its vertices are moved, so a place may be in a triangle of a neighbour
  const double side_m = own == CellIndex::kNone ? neighbourhood_.finest_m : sheet_->cells[own].side_m;
  for (const Vec2 aside :
       {Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1}, Vec2{1, 1}, Vec2{-1, 1}, Vec2{-1, -1}, Vec2{1, -1}}) {
    const std::uint32_t beside = sheet_->index.at(place + aside * (kJitter * side_m));
    if (beside == CellIndex::kNone || beside == own) continue;
    if (const auto height_m = in_cell(beside)) return height_m;
  }
  return std::nullopt;
}

const Patch* AroundSurface::patch_at(Vec2 place) const {
  const std::uint32_t cell = sheet_->index.at(place);
  return cell == CellIndex::kNone ? nullptr : &sheet_->patches[cell];
}

double AroundSurface::distance_from_grid_m() const {
  constexpr double kNear_m = 256;
  double most_m = 0;
  for (std::size_t row = 0; row < around_.rows(); ++row)
    for (std::size_t column = 0; column < around_.columns(); ++column) {
      const Vec2 p = around_.vertex(column, row);
      if (neighbourhood_.away_m({p, p}) < kNear_m) continue;
      const auto height_m = height_m_at(p);
      if (!height_m) continue;
      const double grid_m = around_.heights_m[around_.index(column, row)] - lowered_m(neighbourhood_, p);
      most_m = std::max(most_m, std::abs(*height_m - grid_m));
    }
  return std::ceil(most_m);
}

}  // namespace citykiln::surroundings
