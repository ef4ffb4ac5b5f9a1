#include "compiler/verify/heights/measure_footing.h"

#include <algorithm>
#include <map>
#include <set>

#include "compiler/buildings/meshes/passageways.h"

namespace citykiln::verify {
namespace {

using buildings::Building;

/// Returns the gap between the ground and a wall's lower end. @param ground_m  Height of the ground below the corner.
double gap_m_at(Vec2 corner, double wall_m, double ground_m, double allowed_m, const GroundHeightAt& ground) {
  if (wall_m - ground_m <= allowed_m) return wall_m - ground_m;
  return wall_m - ground(corner, allowed_m).value_or(ground_m);
}

/// Returns the largest gap below a building's corners inside the box. @param corners  Is raised by the corners with
/// known heights.
GapBelow gap_below(const Building& building, const Box2& box, double allowed_m, const GroundHeightAt& ground,
                   const WallBaseAt& wall, std::uint64_t& corners) {
  GapBelow largest{building.id.osm, -1e9, {}};
  const auto look_at = [&](const Ring& ring) {
    for (const Vec2 corner : ring) {
      if (!box.contains_half_open(corner) || buildings::is_in_opening(building, corner)) continue;
      const std::optional<double> ground_m = ground(corner, 0), wall_m = wall(building, corner);
      if (!ground_m || !wall_m) continue;
      ++corners;
      if (const double gap_m = gap_m_at(corner, *wall_m, *ground_m, allowed_m, ground); gap_m > largest.gap_m)
        largest.gap_m = gap_m, largest.corner = corner;
    }
  };
  look_at(building.footprint.outer);
  for (const Ring& hole : building.footprint.holes) look_at(hole);
  return largest;
}

/// A vertical edge of a wall.
struct UprightEdge {
  double top_m = 0, low_m = 0;
};
/// Vertical edges by feature and place.
using Walls = std::map<std::pair<OsmId, Vec2>, std::vector<UprightEdge>>;

/// Returns the lower end of the chain of wall edges that begins at the floor and has no gaps wider than packing makes;
/// empty if no wall reaches the floor. Kerbs and vertical faces of the ground below a building also have the building's
/// id, but they end at the ground.
std::optional<double> lowest_m(std::vector<UprightEdge> walls, double floor_m) {
  std::ranges::sort(walls, std::ranges::greater{}, &UprightEdge::top_m);
  std::optional<double> lowest_m;
  for (const UprightEdge& wall : walls)
    if (wall.top_m >= std::min(lowest_m.value_or(floor_m), floor_m) - kAllowedGap_m)
      lowest_m = std::min(lowest_m.value_or(wall.low_m), wall.low_m);
  return lowest_m;
}

void add_wall(const bake::BakedTile& tile, const bake::Primitive& primitive,
              const std::array<std::uint32_t, 3>& corners, const std::set<OsmId>& houses, Walls& walls) {
  const OsmId feature = tile.features[primitive.features[corners[0]]];
  if (!houses.contains(feature)) return;
  std::array<Vec3, 3> p;
  for (std::size_t i = 0; i < 3; ++i) {
    const bake::Float3& q = primitive.positions[corners[i]];
    p[i] = Vec3{q[0], q[1], q[2]} + tile.origin;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 a = p[i], b = p[(i + 1) % 3];
    if (in_plan(a) == in_plan(b)) walls[{feature, in_plan(a)}].push_back({std::max(a.z, b.z), std::min(a.z, b.z)});
  }
}

Walls walls_of(const scene::Chunk& chunk, const bake::BakedTile& tile) {
  std::set<OsmId> houses;
  for (const Building& building : chunk.buildings) houses.insert(building.id.osm);
  Walls walls;
  for (const bake::Primitive& primitive : tile.primitives)
    for (const auto& triangle : primitive.triangles) add_wall(tile, primitive, triangle, houses, walls);
  return walls;
}

// The lowest floor of all buildings with the same id.
std::map<OsmId, double> floors_of(const scene::Chunk& chunk) {
  std::map<OsmId, double> floors_m;
  for (const Building& building : chunk.buildings) {
    double& floor_m = floors_m.try_emplace(building.id.osm, building.floor_m).first->second;
    floor_m = std::min(floor_m, building.floor_m);
  }
  return floors_m;
}

}  // namespace

Footing combined(const Footing& a, const Footing& b) {
  const Footing& worst = b.largest_gap_m > a.largest_gap_m ? b : a;
  Footing sum{a.corners + b.corners, worst.largest_gap_m, worst.worst, a.floating};
  sum.floating.insert(sum.floating.end(), b.floating.begin(), b.floating.end());
  return sum;
}

Footing measure_footing(const scene::Chunk& chunk, const Box2& box, double allowed_m, const GroundHeightAt& ground,
                        const WallBaseAt& wall) {
  Footing footing;
  for (const Building& building : chunk.buildings) {
    if (!building.stands_on_ground) continue;
    const GapBelow gap = gap_below(building, box, allowed_m, ground, wall, footing.corners);
    if (gap.gap_m > allowed_m) footing.floating.push_back(gap);
    if (gap.gap_m > footing.largest_gap_m) footing.largest_gap_m = gap.gap_m, footing.worst = gap.building;
  }
  return footing;
}

Footing measure_footing(const scene::Chunk& chunk, const Box2& box, double allowed_m, const bake::BakedTile& tile,
                        const GroundIndex& ground) {
  const Walls walls = walls_of(chunk, tile);
  const std::map<OsmId, double> floors_m = floors_of(chunk);
  const auto ground_under = [&](Vec2 p, double within_m) -> std::optional<double> {
    if (within_m > 0) return highest_ground_m(ground, p, within_m);
    const std::vector<GroundHit> places = ground_at(ground, p);
    // at a step in the ground the building stands on the upper side; the step's vertical face closes the gap below
    return places.empty() ? std::nullopt : std::optional(places.back().z_m);
  };
  const auto wall_at = [&](const Building& building, Vec2 p) -> std::optional<double> {
    const auto found = walls.find({building.id.osm, p});
    return found == walls.end() ? std::nullopt : lowest_m(found->second, floors_m.at(building.id.osm));
  };
  return measure_footing(chunk, box, allowed_m, ground_under, wall_at);
}

}  // namespace citykiln::verify
