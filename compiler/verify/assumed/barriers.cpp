#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "compiler/contract/derived_id.h"
#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/segment.h"
#include "compiler/verify/assumed/measure_assumed.h"
#include "compiler/verify/standing/taken_land.h"

namespace citykiln::verify {
namespace {

using map::LandCoverClass;
using roads::Road;

// The axes of ways on the ground, and doors.
struct RailingObstacles {
  struct Axis {
    Vec2 a, b;
    OsmId way;
  };
  std::vector<Axis> axes;
  BoxGrid grid;
  std::vector<Vec2> doors;
  BoxGrid door_grid;
};

constexpr double kDoorClear_m = 1;

std::vector<Vec2> doors_of(const scene::Chunk& chunk) {
  std::vector<Vec2> doors;
  for (const buildings::Building& building : chunk.buildings) {
    const Ring& ring = building.footprint.outer;
    for (std::size_t e = 0; e < building.facade_edges.size(); ++e)
      for (std::uint32_t slot = 0; slot < buildings::kDoorSlots; ++slot)
        if ((building.facade_edges[e].doors >> slot & 1) != 0)
          doors.push_back(ring[e] + (ring[(e + 1) % ring.size()] - ring[e]) * ((slot + 0.5) / buildings::kDoorSlots));
  }
  return doors;
}

RailingObstacles railing_obstacles(const scene::Chunk& chunk) {
  RailingObstacles obstacles;
  std::vector<Box2> boxes, door_boxes;
  for (const Road& road : chunk.roads)
    for (std::size_t i = 0; i + 1 < road.axis.size(); ++i) {
      obstacles.axes.push_back({road.axis[i], road.axis[i + 1], road.id.osm});
      boxes.push_back(box_of_segment(road.axis[i], road.axis[i + 1]));
    }
  obstacles.grid = grid_of(boxes, 16);
  obstacles.doors = doors_of(chunk);
  for (const Vec2 door : obstacles.doors) door_boxes.push_back(Box2{door, door}.widened(kDoorClear_m));
  obstacles.door_grid = grid_of(door_boxes, 16);
  return obstacles;
}

// The mapped way, or the element of the land cover, that a railing is in the way of. An empty id stands for a door.
std::optional<OsmId> blocked_by(const RailingObstacles& obstacles, const ground::LandCoverIndex& land_cover, Vec2 p) {
  const auto is_at_door = [&](std::uint32_t i) { return distance(obstacles.doors[i], p) < kDoorClear_m; };
  if (std::ranges::any_of(boxes_about(obstacles.door_grid, p), is_at_door)) return OsmId{};
  const std::uint32_t top = ground::land_cover_at(land_cover, p);
  if (top == ground::kNoLandCover) return std::nullopt;
  const ground::LandCoverPolygon& surface = land_cover.surfaces[top];
  if (surface.surface == LandCoverClass::kSteps) return surface.id.osm;
  const OsmId taken = taken_element_at(land_cover, p);
  return taken.type == OsmType::kNone ? std::nullopt : std::optional(taken);
}

std::optional<OsmId> way_across(const RailingObstacles& obstacles, OsmId own, Vec2 a, Vec2 b) {
  for (const std::uint32_t i : boxes_about(obstacles.grid, box_of_segment(a, b))) {
    const RailingObstacles::Axis& axis = obstacles.axes[i];
    if (axis.way != own && crossing_shares(a, b, axis.a, axis.b)) return axis.way;
  }
  return std::nullopt;
}

void test_railing(const props::Barrier& railing, const RailingObstacles& obstacles,
                  const ground::LandCoverIndex& land_cover, const Box2& box, AssumedTests& found) {
  const auto test = [&](std::optional<OsmId> on, Vec2 at) {
    ++found.tested;
    if (on && found.conflicts++ == 0) found.at = at, found.element = railing.id.osm, found.obstacle = *on;
  };
  for (std::size_t i = 0; i + 1 < railing.axis.size(); ++i) {
    const Vec2 a = railing.axis[i], b = railing.axis[i + 1];
    if (!box.contains(a) || !box.contains(b)) continue;
    test(way_across(obstacles, railing.id.osm, a, b), a);
    const int steps = std::max(1, static_cast<int>(std::ceil(distance(a, b))));
    for (int k = 0; k <= steps; ++k) {
      const Vec2 p = a + (b - a) * (static_cast<double>(k) / steps);
      test(blocked_by(obstacles, land_cover, p), p);
    }
  }
}

}  // namespace

AssumedTests measure_assumed_railings(const scene::Chunk& chunk, const ground::LandCoverIndex& land_cover,
                                      const Box2& box) {
  AssumedTests found;
  const auto is_railing = [](const props::Barrier& b) { return b.kind == map::BarrierKind::kRailing; };
  if (std::ranges::none_of(chunk.barriers, is_railing)) return found;
  const RailingObstacles obstacles = railing_obstacles(chunk);
  for (const props::Barrier& railing : chunk.barriers)
    if (is_railing(railing)) test_railing(railing, obstacles, land_cover, box, found);
  return found;
}

AssumedTests measure_assumed_hedges(const scene::Chunk& chunk, const ground::LandCoverIndex& land_cover,
                                    const Box2& box) {
  constexpr double kHedgeStep_m = 2;
  AssumedTests found;
  for (const props::Barrier& hedge : chunk.barriers) {
    if (!is_of_field(hedge.id) && !is_of_roadside(hedge.id)) continue;
    for (std::size_t i = 0; i + 1 < hedge.axis.size(); ++i) {
      const Vec2 a = hedge.axis[i], b = hedge.axis[i + 1];
      const int steps = std::max(1, static_cast<int>(distance(a, b) / kHedgeStep_m));
      for (int k = 0; k < steps; ++k) {
        const Vec2 p = a + (b - a) * ((k + 0.5) / steps);
        if (!box.contains_half_open(p)) continue;
        ++found.tested;
        const OsmId on = taken_element_at(land_cover, p);
        if (on.type != OsmType::kNone && found.conflicts++ == 0)
          found.at = p, found.element = hedge.id.osm, found.obstacle = on;
      }
    }
  }
  return found;
}

}  // namespace citykiln::verify
