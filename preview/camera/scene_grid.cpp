#include "preview/camera/scene_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace citykiln::preview {
namespace {

using materials::Material;

constexpr double kFarBelow = std::numeric_limits<double>::infinity();

Vec3 point_of(const bake::BakedTile& tile, const bake::Float3& p) { return tile.origin + bake::widened(p); }

bool is_finite(Vec3 p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

Box2 box_around(std::span<const bake::BakedTile> tiles) {
  Box2 box;
  for (const bake::BakedTile& tile : tiles)
    for (const bake::Primitive& primitive : tile.primitives)
      for (const bake::Float3& p : primitive.positions)
        if (is_finite(point_of(tile, p))) box.grow(in_plan(point_of(tile, p)));
  return box.is_empty() ? Box2{{-100, -100}, {100, 100}} : box;
}

// Garden walls, ramparts, bridges.
bool is_no_building(bake::Layer layer) { return layer == bake::Layer::kProps || layer == bake::Layer::kStructures; }

}  // namespace

bool is_built(Material material) {
  switch (material) {
    case Material::kPlaster:
    case Material::kBrick:
    case Material::kStone:
    case Material::kTimber:
    case Material::kGlassFacade:
    case Material::kMetalCladding:
    case Material::kRoofTile:
    case Material::kSlate:
    case Material::kFlatRoof:
    case Material::kMetalRoof:
    case Material::kBareMetal:
      return true;
    default:
      return false;
  }
}

bool is_street(Material material) {
  return material == Material::kAsphalt || material == Material::kOldAsphalt || material == Material::kStreetAsphalt ||
         material == Material::kPaving;
}

SceneGrid::SceneGrid(std::span<const bake::BakedTile> tiles)
    : box_(box_around(tiles)), columns_(kAcross * kAcross, {kFarBelow, -kFarBelow}) {
  for (const bake::BakedTile& tile : tiles)
    for (const bake::Primitive& primitive : tile.primitives) add(tile, primitive);
  find_core();
}

std::size_t SceneGrid::column_at(Vec2 at) const {
  const auto step = [](double v, double low, double size) {
    return std::clamp(static_cast<int>((v - low) / std::max(size, 1e-3) * kAcross), 0, kAcross - 1);
  };
  return static_cast<std::size_t>(step(at.y, box_.min.y, box_.height()) * kAcross +
                                  step(at.x, box_.min.x, box_.width()));
}

Vec2 SceneGrid::middle_of(std::size_t column) const {
  const double x = static_cast<double>(column % kAcross) + 0.5, y = static_cast<double>(column / kAcross) + 0.5;
  return box_.min + Vec2{box_.width() * x / kAcross, box_.height() * y / kAcross};
}

void SceneGrid::add(const bake::BakedTile& tile, const bake::Primitive& primitive) {
  for (const bake::Float3& position : primitive.positions) {
    const Vec3 p = point_of(tile, position);
    if (!is_finite(p)) continue;
    Column& column = columns_[column_at(in_plan(p))];
    column.low_m = std::min(column.low_m, p.z);
    column.high_m = std::max(column.high_m, p.z);
  }
  if (primitive.layer == bake::Layer::kBuildings) add_buildings(tile, primitive);
  if (!is_built(primitive.material) || is_no_building(primitive.layer)) return;
  for (const auto& t : primitive.triangles) {
    const Vec3 a = point_of(tile, primitive.positions[t[0]]), b = point_of(tile, primitive.positions[t[1]]);
    const Vec3 c = point_of(tile, primitive.positions[t[2]]);
    if (is_finite(a) && is_finite(b) && is_finite(c)) add_built(a, b - a, c - a);
  }
}

void SceneGrid::add_buildings(const bake::BakedTile& tile, const bake::Primitive& primitive) {
  std::uint32_t last = 0;  // neighbours belong to one building
  for (const std::uint32_t feature : primitive.features)
    if (std::exchange(last, feature) != feature) buildings_.insert(tile.features[feature]);
}

void SceneGrid::add_built(Vec3 a, Vec3 u, Vec3 v) {
  constexpr double kMostParts = 16;
  const double column_m = std::max({box_.width() / kAcross, box_.height() / kAcross, 1.0});
  const double longest = std::max({length(u), length(v), length(u - v)});
  const int n = static_cast<int>(std::clamp(std::ceil(longest / column_m), 1.0, kMostParts));
  const double part_m2 = length(cross(u, v)) / (n * (n + 1.0));
  for (int i = 0; i < n; ++i)
    for (int j = 0; i + j < n; ++j)
      columns_[column_at(in_plan(a + u * ((i + 1.0 / 3) / n) + v * ((j + 1.0 / 3) / n)))].built_m2 += part_m2;
}

std::vector<Vec3> SceneGrid::points() const {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (columns_[i].low_m > columns_[i].high_m) continue;
    points.push_back(at_height(middle_of(i), columns_[i].low_m));
    points.push_back(at_height(middle_of(i), columns_[i].high_m));
  }
  if (points.empty()) points = {{box_.min.x, box_.min.y, 0}, {box_.max.x, box_.max.y, 10}};
  return points;
}

std::vector<SceneGrid::BuiltPoint> SceneGrid::built_points() const {
  std::vector<BuiltPoint> points;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (columns_[i].built_m2 <= 0 || columns_[i].low_m > columns_[i].high_m) continue;
    for (const double z : {columns_[i].low_m, columns_[i].high_m})
      points.push_back({at_height(middle_of(i), z), columns_[i].built_m2});
  }
  return points;
}

double SceneGrid::top_m() const {
  double top_m = -kFarBelow;
  for (const Column& column : columns_) top_m = std::max(top_m, column.high_m);
  return std::isfinite(top_m) ? top_m : 0;
}

double SceneGrid::built_about(std::size_t column, int radius) const {
  const int x = static_cast<int>(column) % kAcross, y = static_cast<int>(column) / kAcross;
  double sum = 0;
  for (int j = std::max(y - radius, 0); j <= std::min(y + radius, kAcross - 1); ++j)
    for (int i = std::max(x - radius, 0); i <= std::min(x + radius, kAcross - 1); ++i)
      sum += columns_[j * kAcross + i].built_m2;
  return sum;
}

void SceneGrid::find_core() {
  // a window of some 300 m
  const double column_m = std::max(box_.width(), box_.height()) / kAcross;
  const int radius = std::clamp(static_cast<int>(150 / std::max(column_m, 1e-3)), 1, 12);
  std::size_t best = columns_.size();
  double most = 0;
  for (std::size_t i = 0; i < columns_.size(); ++i)
    if (const double built = built_about(i, radius); built > most) most = built, best = i;
  const Vec2 at = best < columns_.size() ? middle_of(best) : box_.centre();
  // the lowest point of the column, which is on the street and not on a roof
  const std::vector<Vec3> all = points();
  const auto nearest =
      std::ranges::min_element(all, {}, [&](const Vec3& p) { return std::pair(distance(in_plan(p), at), p.z); });
  core_ = at_height(at, nearest->z);
}

double SceneGrid::highest_m(Vec2 at) const {
  if (!box_.contains(at)) return -kFarBelow;
  return columns_[column_at(at)].high_m;
}

double SceneGrid::lowest_m(Vec2 at) const {
  const Column& column = columns_[column_at(at)];
  return box_.contains(at) && column.low_m <= column.high_m ? column.low_m : -kFarBelow;
}

}  // namespace citykiln::preview
