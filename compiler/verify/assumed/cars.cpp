#include <algorithm>
#include <set>
#include <string_view>
#include <vector>

#include "compiler/buildings/planning/doors.h"
#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/segment.h"
#include "compiler/map/things/thing_role.h"
#include "compiler/verify/assumed/measure_assumed.h"

namespace citykiln::verify {
namespace {

using map::LandCoverGroup;

// The distance from a car to a door, and the width of a car's edge that may lie on other ground.
constexpr double kBeforeDoor_m = 1.25, kCarEdge_m = 0.3125;

bool is_car(std::string_view mesh) {
  const std::string_view name = map::name_of(map::ThingRole::kCar);
  return mesh == name || (mesh.starts_with(name) && mesh.substr(name.size()).starts_with("_") &&
                          mesh.find_first_not_of("0123456789", name.size() + 1) == mesh.npos);
}

// The rectangle of an upright copy of a mesh, less the edge: a car on a slope is tilted by so little that its plan is
// that of the level one.
Ring ring_of(const bake::InstancedMesh& mesh, std::size_t copy, Vec3 origin) {
  Box2 box;
  for (const bake::Primitive& primitive : mesh.primitives)
    for (const bake::Float3& p : primitive.positions) box.grow({p[0], p[1]});
  box = box.widened(-kCarEdge_m);
  const bake::Float3& offset = mesh.translations[copy];
  const Vec2 at = in_plan(Vec3{offset[0], offset[1], offset[2]} + origin);
  const bake::Float4& turn = mesh.rotations[copy];
  const double norm = static_cast<double>(turn[2]) * turn[2] + static_cast<double>(turn[3]) * turn[3];
  const double cos_yaw = (static_cast<double>(turn[3]) * turn[3] - static_cast<double>(turn[2]) * turn[2]) / norm,
               sin_yaw = 2.0 * turn[2] * turn[3] / norm;
  Ring ring;
  for (const Vec2 p : {box.min, Vec2{box.max.x, box.min.y}, box.max, Vec2{box.min.x, box.max.y}})
    ring.push_back(at + Vec2{p.x * cos_yaw - p.y * sin_yaw, p.x * sin_yaw + p.y * cos_yaw});
  return ring;
}

// Ground on which no part of a car may be; others than mapped spaces must also be paved, or a yard.
bool is_ground_for_cars(const ground::LandCoverPolygon& surface, bool is_in_space) {
  switch (map::values_of(surface.surface).group) {
    case LandCoverGroup::kBuilding:
    case LandCoverGroup::kWater:
    case LandCoverGroup::kRail:
      return false;
    case LandCoverGroup::kRoad:
    case LandCoverGroup::kPaved:
      return true;
    default:
      return is_in_space || ground::is_yard(surface);
  }
}

// The element that bars a car: below a corner or its middle; none if its ground is free.
std::optional<OsmId> bar_of(const Ring& ring, bool is_in_space, const ground::LandCoverIndex& land_cover) {
  std::vector<Vec2> places = ring;
  places.push_back((ring[0] + ring[2]) * 0.5);
  for (const Vec2 p : places) {
    if (!land_cover.box.contains(p)) continue;
    const std::uint32_t top = ground::land_cover_at(land_cover, p);
    if (top == ground::kNoLandCover) {
      if (!is_in_space) return OsmId{};
    } else if (!is_ground_for_cars(land_cover.surfaces[top], is_in_space)) {
      return land_cover.surfaces[top].id.osm;
    }
  }
  return std::nullopt;
}

// The doors of a tile's buildings.
struct DoorSquares {
  std::vector<Vec2> at;
  BoxGrid grid;
};

DoorSquares door_squares_of(const scene::Chunk& chunk) {
  DoorSquares doors;
  std::vector<Box2> boxes;
  for (const buildings::Building& building : chunk.buildings)
    for (const Vec2 door : buildings::door_positions(building)) {
      doors.at.push_back(door);
      boxes.push_back(Box2{door, door}.widened(kBeforeDoor_m));
    }
  if (!boxes.empty()) doors.grid = grid_of(boxes, 32);
  return doors;
}

bool is_before_door(const Ring& ring, const DoorSquares& doors) {
  if (doors.at.empty()) return false;
  return any_about(doors.grid, box_of(ring), [&](std::uint32_t i) {
    return distance_to_ring(ring, doors.at[i]) < kBeforeDoor_m || winding_number(ring, doors.at[i]) != 0;
  });
}

}  // namespace

AssumedTests measure_parked_cars(const bake::BakedTile& tile, const scene::Chunk& chunk,
                                 const ground::LandCoverIndex& land_cover) {
  std::set<OsmId> spaces;
  for (const things::Thing& thing : chunk.things)
    if (map::role_of(thing.form.kind) == map::ThingRole::kCar) spaces.insert(thing.id.osm);
  const DoorSquares doors = door_squares_of(chunk);
  AssumedTests found;
  for (const bake::InstancedMesh& mesh : tile.instanced) {
    if (!is_car(mesh.name)) continue;
    for (std::size_t i = 0; i < mesh.translations.size(); ++i) {
      const Ring ring = ring_of(mesh, i, tile.origin);
      const OsmId element = tile.features[mesh.features[i]];
      ++found.tested;
      std::optional<OsmId> bar = bar_of(ring, spaces.contains(element), land_cover);
      if (!bar && is_before_door(ring, doors)) bar = OsmId{};
      if (!bar) continue;
      if (found.conflicts++ == 0) found.at = (ring[0] + ring[2]) * 0.5, found.element = element, found.obstacle = *bar;
    }
  }
  return found;
}

}  // namespace citykiln::verify
