#include "compiler/commands/measure_footing.h"

#include <algorithm>
#include <map>

#include "compiler/contract/tolerance.h"

namespace citykiln::commands {
namespace {

using buildings::Building;

/// Half-open, so that a corner on a border between tiles is looked at once.
bool is_in(const Box2& box, Vec2 p) {
  return box.min.x <= p.x && p.x < box.max.x && box.min.y <= p.y && p.y < box.max.y;
}

void consider(Footing& footing, const Building& building, double gap_m) {
  ++footing.corners;
  if (gap_m <= footing.largest_gap_m) return;
  footing.largest_gap_m = gap_m;
  footing.worst = building.id.osm;
}

/// The largest gap under a building's corners.
double gap_under(const Building& building, const Box2& box, const GroundUnder& ground, const WallAt& wall,
                 Footing& footing) {
  double largest_m = -1e9;
  const auto look_at = [&](const Ring& ring) {
    for (const Vec2 corner : ring) {
      if (!is_in(box, corner)) continue;
      const std::optional<double> ground_m = ground(corner), wall_m = wall(building, corner);
      if (!ground_m || !wall_m) continue;
      largest_m = std::max(largest_m, *wall_m - *ground_m);
      consider(footing, building, *wall_m - *ground_m);
    }
  };
  look_at(building.footprint.outer);
  for (const Ring& hole : building.footprint.holes) look_at(hole);
  return largest_m;
}

/// The lowest point of walls by feature and place.
using LowestWalls = std::map<std::pair<OsmId, Vec2>, double>;

void add_wall(const bake::BakedTile& tile, const bake::Primitive& primitive,
              const std::array<std::uint32_t, 3>& corners, const std::map<OsmId, double>& floors_m,
              LowestWalls& walls) {
  const OsmId feature = tile.features[primitive.features[corners[0]]];
  const auto floor = floors_m.find(feature);
  if (floor == floors_m.end()) return;
  std::array<Vec3, 3> p;
  for (std::size_t i = 0; i < 3; ++i) {
    const bake::Float3& q = primitive.positions[corners[i]];
    p[i] = Vec3{q[0], q[1], q[2]} + tile.origin;
  }
  const double top_m = std::max({p[0].z, p[1].z, p[2].z});
  const bool is_upright = cross(in_plan(p[1] - p[0]), in_plan(p[2] - p[0])) == 0;
  // kerbs and walls of the ground under it are the building's too, but end at the ground
  if (!is_upright || top_m < floor->second - kQuantum_m) return;
  for (const Vec3& q : p) {
    double& lowest_m = walls.try_emplace({feature, in_plan(q)}, q.z).first->second;
    lowest_m = std::min(lowest_m, q.z);
  }
}

LowestWalls walls_of(const scene::Chunk& chunk, const bake::BakedTile& tile) {
  // of buildings with one name the lowest floor
  std::map<OsmId, double> floors_m;
  for (const Building& building : chunk.buildings) {
    double& floor_m = floors_m.try_emplace(building.id.osm, building.floor_m).first->second;
    floor_m = std::min(floor_m, building.floor_m);
  }
  LowestWalls walls;
  for (const bake::Primitive& primitive : tile.primitives)
    for (const auto& triangle : primitive.triangles) add_wall(tile, primitive, triangle, floors_m, walls);
  return walls;
}

}  // namespace

Footing worse(const Footing& a, const Footing& b) {
  const Footing& worst = b.largest_gap_m > a.largest_gap_m ? b : a;
  return {a.corners + b.corners, a.floating + b.floating, worst.largest_gap_m, worst.worst};
}

Footing measure_footing(const scene::Chunk& chunk, const Box2& box, double allowed_m, const GroundUnder& ground,
                        const WallAt& wall) {
  Footing footing;
  for (const Building& building : chunk.buildings)
    if (building.stands_on_ground) footing.floating += gap_under(building, box, ground, wall, footing) > allowed_m;
  return footing;
}

Footing measure_footing(const scene::Chunk& chunk, const Box2& box, double allowed_m, const bake::BakedTile& tile,
                        const GroundIndex& ground) {
  const LowestWalls walls = walls_of(chunk, tile);
  const auto ground_under = [&](Vec2 p) -> std::optional<double> {
    const std::vector<GroundPlace> places = ground_at(ground, p);
    // where the ground steps at a corner, a house stands on the upper side: the step's own wall closes what is below
    return places.empty() ? std::nullopt : std::optional(places.back().z_m);
  };
  const auto wall_at = [&](const Building& building, Vec2 p) -> std::optional<double> {
    const auto found = walls.find({building.id.osm, p});
    return found == walls.end() ? std::nullopt : std::optional(found->second);
  };
  return measure_footing(chunk, box, allowed_m, ground_under, wall_at);
}

}  // namespace citykiln::commands
