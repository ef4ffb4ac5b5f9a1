#include "compiler/map/buildings/shell.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "compiler/geometry/polygons/clip_polygon.h"
#include "compiler/geometry/polygons/offset_polygon.h"
#include "compiler/geometry/snap.h"
#include "compiler/map/buildings/building_classes.h"

namespace citykiln::map {
namespace {

constexpr double kLeastRoom_m2 = 2, kRuin_m = 3;

}  // namespace

Polygon shell_walls(const Polygon& polygon) {
  if (!polygon.holes.empty()) return polygon;
  const std::vector<double> depth_m(polygon.outer.size(), kShellWall_m);
  OffsetPolygon offset = inset(polygon, depth_m);
  if (offset.moved.size() != 1 || !offset.moved.front().holes.empty()) return polygon;
  Ring room = std::move(offset.moved.front().outer);
  for (Vec2& p : room) p = snapped(p);
  const std::vector<Polygon> rooms = united({{room}});
  if (rooms.size() != 1 || !rooms.front().holes.empty() || area_m2(rooms.front()) < kLeastRoom_m2) return polygon;
  Polygon walls{polygon.outer, {rooms.front().outer}};
  std::ranges::reverse(walls.holes.front());
  return walls;
}

void make_shell(bool is_ruin, bool is_height_tagged, Footprint& footprint) {
  using materials::Material;
  const Material bare = is_ruin ? Material::kStone : Material::kConcrete;
  footprint.wall_material = footprint.wall_material.value_or(bare);
  footprint.roof_material = bare;
  footprint.has_roof_shape = true, footprint.roof = {};
  footprint.building_class = static_cast<std::uint8_t>(BuildingClass::kShell);
  if (is_ruin && !is_height_tagged) footprint.height_m = footprint.min_height_m + kRuin_m;
}

}  // namespace citykiln::map
