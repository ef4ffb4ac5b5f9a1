#include "compiler/verify/standing/measure_assumed.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>
#include <vector>

#include "compiler/contract/derived_id.h"
#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/polygons/centroid.h"
#include "compiler/geometry/segment.h"
#include "compiler/map/things/thing_role.h"
#include "compiler/props/luminaire.h"
#include "compiler/roads/junctions/junction.h"
#include "compiler/roads/width_limits/narrowed_section.h"
#include "compiler/scene/land_cover.h"
#include "compiler/things/facing.h"
#include "compiler/verify/standing/taken_land.h"

namespace citykiln::verify {
namespace {

using map::LandCoverClass;
using map::LandCoverGroup;
using roads::Road;

constexpr double kPavementStep_m = 4, kAssumedBucket_m = 32;
// Narrower pavements are kerb stones.
constexpr double kLeastMeasured_m = 0.25;
// Rounding of outlines.
constexpr double kInside_m = 0.05;

LandCoverGroup group_of_class(LandCoverClass surface) { return map::values_of(surface).group; }

// A segment of a way that nothing assumed may cover.
struct MappedSegment {
  std::uint32_t road, segment;
};

// The mapped objects of a chunk that nothing assumed may cover.
struct Mapped {
  const scene::Chunk& chunk;
  std::vector<ground::LandCoverPolygon> areas;  // Water, buildings and squares.
  ground::LandCoverIndex index;                 // The index of `areas`.
  std::vector<MappedSegment> segments{};
  BoxGrid grid{};  // The boxes of `segments`.
};

std::vector<ground::LandCoverPolygon> areas_to_avoid(const scene::Chunk& chunk) {
  std::vector<ground::LandCoverPolygon> areas;
  for (const ground::LandCoverPolygon& surface : chunk.surfaces)
    if (const auto group = group_of_class(surface.surface); group == LandCoverGroup::kWater ||
                                                            group == LandCoverGroup::kBuilding ||
                                                            surface.surface == LandCoverClass::kSquare)
      areas.push_back(surface);
  for (const buildings::Building& building : chunk.buildings)
    if (building.stands_on_ground) areas.push_back(scene::footprint_surface(building));
  return areas;
}

void add_segments(Mapped& mapped) {
  std::vector<Box2> boxes;
  const std::vector<Road>& all = mapped.chunk.roads;
  for (std::uint32_t r = 0; r < all.size(); ++r)
    for (std::uint32_t i = 0; i + 1 < all[r].axis.size(); ++i) {
      mapped.segments.push_back({r, i});
      const double widest_m = std::max(roads::widest_left_m(all[r]), roads::widest_right_m(all[r]));
      boxes.push_back(box_of_segment(all[r].axis[i], all[r].axis[i + 1]).widened(widest_m));
    }
  if (!boxes.empty()) mapped.grid = grid_of(boxes, kAssumedBucket_m);
}

// The middle of an assumed pavement at a place along its road.
struct PavementPlace {
  const Road& road;
  Vec2 on_axis, at;
};

bool has_vertex(const Road& road, Vec2 p) { return std::ranges::find(road.axis, p) != road.axis.end(); }

// True if two roads meet at a node, or one begins or ends near it on a third road that has it: roads are cut near
// junctions.
bool meet_at(const Mapped& mapped, const Road& other, Vec2 node) {
  if (has_vertex(other, node)) return true;
  for (const Vec2 end : {other.axis.front(), other.axis.back()}) {
    if (distance(end, node) >= roads::kJunctionRadius_m) continue;
    for (const std::uint32_t i : boxes_about(mapped.grid, node)) {
      const Road& between = mapped.chunk.roads[mapped.segments[i].road];
      if (has_vertex(between, node) && has_vertex(between, end)) return true;
    }
  }
  return false;
}

bool meet_near(const Mapped& mapped, const Road& one, const Road& other, Vec2 p) {
  return std::ranges::any_of(one.axis, [&](Vec2 node) {
    return distance(node, p) < roads::kJunctionRadius_m && meet_at(mapped, other, node);
  });
}

// Paths at a greater angle to a road join its pavement: the sine of about 37 degrees.
constexpr double kJoins = 0.6;

// True if a place lies between the kerbs of another road, on a railway, or on a path that runs along the road.
bool is_on_way(const PavementPlace& place, const Road& other, std::uint32_t segment) {
  const Vec2 a = other.axis[segment], b = other.axis[segment + 1];
  const double half_m = cross(b - a, place.at - a) > 0 ? roads::left_m(other) : roads::right_m(other);
  if (a == b || distance_to_segment(a, b, place.at) >= half_m - kInside_m) return false;
  const bool is_path = group_of_class(other.surface) == LandCoverGroup::kPath;
  return !is_path || std::abs(dot(unit(b - a), unit(place.at - place.on_axis))) < kJoins;
}

// The mapped element on which a place of a pavement lies; none if it is free.
OsmId mapped_at(const Mapped& mapped, const PavementPlace& place) {
  const std::uint32_t area = ground::land_cover_at(mapped.index, place.at);
  if (area != ground::kNoLandCover && area != ground::land_cover_at(mapped.index, place.on_axis))
    return mapped.areas[area].id.osm;
  if (mapped.segments.empty()) return {};
  for (const std::uint32_t i : boxes_about(mapped.grid, place.at)) {
    const Road& other = mapped.chunk.roads[mapped.segments[i].road];
    if (other.id.osm == place.road.id.osm || !is_on_way(place, other, mapped.segments[i].segment)) continue;
    if (!meet_near(mapped, place.road, other, place.at)) return other.id.osm;
  }
  return {};
}

void test_place(const Mapped& mapped, const PavementPlace& place, AssumedTests& found) {
  ++found.tested;
  const OsmId on = mapped_at(mapped, place);
  if (on.type == OsmType::kNone) return;
  if (found.conflicts++ == 0) found.at = place.at, found.element = place.road.id.osm, found.obstacle = on;
}

void test_pavements(const Mapped& mapped, const Road& road, const Box2& box, AssumedTests& found) {
  const std::vector<double> along_m = roads::distances_along(road);
  for (std::size_t i = 0; i + 1 < road.axis.size(); ++i) {
    const Vec2 a = road.axis[i], b = road.axis[i + 1], left = left_of(unit(b - a));
    const int steps = std::max(1, static_cast<int>(std::ceil(distance(a, b) / kPavementStep_m)));
    for (int k = 0; k < steps; ++k) {
      const double share = (k + 0.5) / steps;
      const Vec2 on_axis = a + (b - a) * share;
      const auto edges = roads::road_edges_at(road, along_m[i] + (along_m[i + 1] - along_m[i]) * share);
      const double offsets_m[] = {(edges.kerb_left_m + edges.left_m) / 2, -(edges.kerb_right_m + edges.right_m) / 2};
      const double widths_m[] = {edges.left_m - edges.kerb_left_m, edges.right_m - edges.kerb_right_m};
      for (const int side : {0, 1}) {
        if ((road.assumed_sides & (side == 0 ? map::kLeftSide : map::kRightSide)) == 0) continue;
        const PavementPlace place{road, on_axis, on_axis + left * offsets_m[side]};
        if (widths_m[side] >= kLeastMeasured_m && box.contains_half_open(place.at)) test_place(mapped, place, found);
      }
    }
  }
}

// Rounding of places along walls.
constexpr double kAlongWall_m = 0.01;
// The spacing of places of a front that are tested against openings.
constexpr double kFrontPlaces_m = 0.5;

bool overlap(double from_m, double to_m, double other_from_m, double other_to_m) {
  return std::min(to_m, other_to_m) - std::max(from_m, other_from_m) > kAlongWall_m;
}

bool is_across_opening(const buildings::Building& building, const buildings::Front& front, Vec2 corner, Vec2 along) {
  const int steps = std::max(1, static_cast<int>((front.to_m - front.from_m) / kFrontPlaces_m));
  return std::ranges::any_of(building.passageways, [&](const buildings::Passageway& opening) {
    const double half_m = std::min(opening.left_m, opening.right_m) - kInside_m;
    for (int i = 0; i <= steps; ++i) {
      const Vec2 p = corner + along * (front.from_m + (front.to_m - front.from_m) * i / steps);
      if (distance_to_polyline(opening.axis, p) < half_m) return true;
    }
    return false;
  });
}

// True if nothing else is on the part of the wall that an assumed front takes.
bool is_on_free_wall(const buildings::Building& building, const buildings::Front& front) {
  const Ring& ring = building.footprint.outer;
  if (front.edge >= ring.size()) return false;
  const Vec2 a = ring[front.edge], b = ring[(front.edge + 1) % ring.size()];
  if (front.from_m < 0 || front.to_m > distance(a, b) + kAlongWall_m || front.from_m >= front.to_m) return false;
  const auto is_taken_by = [&](const auto& other) {
    return other.edge == front.edge && overlap(front.from_m, front.to_m, other.from_m, other.to_m);
  };
  const auto is_taken_by_front = [&](const buildings::Front& other) { return &other != &front && is_taken_by(other); };
  return std::ranges::none_of(building.party_walls, is_taken_by) &&
         std::ranges::none_of(building.fronts, is_taken_by_front) &&
         !is_across_opening(building, front, a, unit(b - a));
}

std::set<OsmId> ways_with_assumed_lamps(const scene::Chunk& chunk) {
  std::set<OsmId> ways;
  const auto add = [&](const auto& all) {
    for (const Road& road : all)
      if (has(road.assumed, Assumption::kLamps)) ways.insert(road.id.osm);
  };
  add(chunk.roads), add(chunk.bridges), add(chunk.tunnels);
  return ways;
}

// The element of taken_land_at(); none if the place is free.
OsmId taken_by(const ground::LandCoverIndex& land_cover, Vec2 p) {
  const ground::LandCoverPolygon* land = taken_land_at(land_cover, p);
  return land != nullptr ? land->id.osm : OsmId{};
}

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
  const OsmId taken = taken_by(land_cover, p);
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

// The places where an assumed mast stands on the ground; none for other things.
std::vector<Vec2> feet_of(const things::Thing& thing) {
  const map::ThingRole role = map::role_of(thing.form.kind);
  if (!is_derived(thing.id) || !map::is_contact(role) || role == map::ThingRole::kContactHanger) return {};
  if (role != map::ThingRole::kContactPortal) return {thing.at};
  const Vec2 half = left_of(things::unit_vector(thing.direction)) * (thing.form.width_m / 2);
  return {thing.at + half, thing.at - half};
}

// The clear space beside a track: 2.5 m of a railway, 1.65 m of a tramway, and what half a mast is at least.
constexpr double kClearOfRailway_m = 2.6, kClearOfTramway_m = 1.75;

OsmId track_too_near(const scene::Chunk& chunk, Vec2 p) {
  for (const Road& road : chunk.roads) {
    if (group_of_class(road.surface) != LandCoverGroup::kRail) continue;
    const double clear_m = road.surface == LandCoverClass::kTram || road.surface == LandCoverClass::kStreetRails
                               ? kClearOfTramway_m
                               : kClearOfRailway_m;
    if (distance_to_polyline(road.axis, p) < clear_m) return road.id.osm;
  }
  return {};
}

constexpr double kYardGrid_m = 4, kInBarrier_m = 0.25;
// Houses of neighbouring lots may touch.
constexpr double kInsideWall_m = 0.125;

// The mapped element in or below which a tree of a yard stands; none if its place is free.
OsmId no_place_for_tree(const scene::Chunk& chunk, const ground::LandCoverIndex& land_cover, Vec2 p) {
  if (const std::uint32_t top = ground::land_cover_at(land_cover, p); top != ground::kNoLandCover) {
    const ground::LandCoverPolygon& surface = land_cover.surfaces[top];
    const OsmId taken = taken_by(land_cover, p);
    if (taken.type != OsmType::kNone) return taken;
    if (group_of_class(surface.surface) == LandCoverGroup::kPath) return surface.id.osm;
  }
  for (const plants::PowerLineCorridor& wire : chunk.corridors)
    if (distance_to_polyline(wire.axis, p) < wire.width_m / 2) return wire.id.osm;
  for (const props::Barrier& barrier : chunk.barriers)
    if (distance_to_polyline(barrier.axis, p) < barrier.width_m / 2 + kInBarrier_m) return barrier.id.osm;
  return {};
}

// True for mapped land on which no yard may lie.
bool is_finer_than_use(const ground::LandCoverPolygon& surface) {
  return !ground::is_yard(surface) && !is_of_field(surface.id) && surface.surface != LandCoverClass::kUnknown &&
         surface.surface != LandCoverClass::kResidential && surface.surface != LandCoverClass::kCommercial &&
         surface.surface != LandCoverClass::kRetail && surface.surface != LandCoverClass::kIndustrial;
}

// Mapped land with an index of its boxes.
struct FinerLand {
  std::vector<const ground::LandCoverPolygon*> all;
  BoxGrid grid;
};

FinerLand finer_land(const scene::Chunk& chunk) {
  FinerLand land;
  std::vector<Box2> boxes;
  for (const ground::LandCoverPolygon& surface : chunk.surfaces) {
    const Box2 box = ground::box_of(surface);
    if (!is_finer_than_use(surface) || box.is_empty()) continue;
    land.all.push_back(&surface);
    boxes.push_back(box);
  }
  if (!boxes.empty()) land.grid = grid_of(boxes, 32);
  return land;
}

// True if a place lies in a polygon, and not on its border, where either side may be on top: outlines of lots are off
// by up to 0.3 m (lots/coarse_outlines.h).
bool is_well_inside(const ground::LandCoverPolygon& surface, Vec2 p) {
  constexpr double kBorder_m = 0.3125;
  for (const Vec2 step : {Vec2{kBorder_m, 0}, Vec2{-kBorder_m, 0}, Vec2{0, kBorder_m}, Vec2{0, -kBorder_m}})
    if (ground::winding_number(surface, p + step) <= 0) return false;
  return true;
}

void test_yard_places(const scene::Chunk& chunk, const ground::LandCoverIndex& land_cover, const Box2& box,
                      AssumedTests& found) {
  const FinerLand land = finer_land(chunk);
  for (double x = box.min.x + kYardGrid_m / 2; x < box.max.x; x += kYardGrid_m)
    for (double y = box.min.y + kYardGrid_m / 2; y < box.max.y; y += kYardGrid_m) {
      const Vec2 p{x, y};
      const std::uint32_t top = ground::land_cover_at(land_cover, p);
      if (top == ground::kNoLandCover || !ground::is_yard(land_cover.surfaces[top])) continue;
      ++found.tested;
      if (land.all.empty()) continue;
      for (const std::uint32_t i : boxes_about(land.grid, p))
        if (is_well_inside(*land.all[i], p)) {
          if (found.conflicts++ == 0)
            found.at = p, found.element = land_cover.surfaces[top].id.osm, found.obstacle = land.all[i]->id.osm;
          break;
        }
    }
}

// The element on which a place of a house lies, other than the house's own lot; none if the place is free.
OsmId no_place_for_house(const scene::Chunk& chunk, const ground::LandCoverIndex& land_cover, OsmId lot, Vec2 p) {
  if (const std::uint32_t top = ground::land_cover_at(land_cover, p); top != ground::kNoLandCover) {
    const ground::LandCoverPolygon& surface = land_cover.surfaces[top];
    const bool is_mapped_path = group_of_class(surface.surface) == LandCoverGroup::kPath;
    const OsmId on = is_mapped_path ? surface.id.osm : taken_by(land_cover, p);
    if (on.type != OsmType::kNone && on != lot) return on;
  }
  for (const buildings::Building& other : chunk.buildings)
    if (other.id.osm != lot && contains(other.footprint, p)) return other.id.osm;
  return {};
}

bool has_assumed_sides(const Road& road) {
  return has(road.assumed, Assumption::kPavements) || has(road.assumed, Assumption::kVerges);
}

}  // namespace

AssumedTests measure_assumed_pavements(const scene::Chunk& chunk, const Box2& box) {
  AssumedTests found;
  const auto has_any = [](const Road& road) { return has_assumed_sides(road); };
  if (std::ranges::none_of(chunk.roads, has_any)) return found;
  Mapped mapped{chunk, areas_to_avoid(chunk), {}};
  mapped.index = ground::index_land_cover(mapped.areas, box.widened(scene::kHalo_m));
  add_segments(mapped);
  for (const Road& road : chunk.roads)
    if (has_any(road)) test_pavements(mapped, road, box, found);
  return found;
}

AssumedTests measure_assumed_lamps(const bake::BakedTile& tile, const scene::Chunk& chunk,
                                   const ground::LandCoverIndex& land_cover) {
  AssumedTests found;
  const std::set<OsmId> ways = ways_with_assumed_lamps(chunk);
  if (ways.empty()) return found;
  for (const bake::InstancedMesh& instanced : tile.instanced) {
    if (!props::lamp_named(instanced.name)) continue;
    for (std::size_t i = 0; i < instanced.translations.size(); ++i) {
      const OsmId way = tile.features[instanced.features[i]];
      if (!ways.contains(way)) continue;
      const bake::Float3& offset = instanced.translations[i];
      const Vec2 at = in_plan(Vec3{offset[0], offset[1], offset[2]} + tile.origin);
      const OsmId on = taken_by(land_cover, at);
      ++found.tested;
      if (on.type == OsmType::kNone) continue;
      if (found.conflicts++ == 0) found.at = at, found.element = way, found.obstacle = on;
    }
  }
  return found;
}

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

AssumedTests measure_assumed_masts(const scene::Chunk& chunk, const ground::LandCoverIndex& land_cover,
                                   const Box2& box) {
  AssumedTests found;
  for (const things::Thing& mast : chunk.things)
    for (const Vec2 foot : feet_of(mast)) {
      if (!box.contains(foot)) continue;
      ++found.tested;
      OsmId on = taken_by(land_cover, foot);
      if (on.type == OsmType::kNone) on = track_too_near(chunk, foot);
      if (on.type == OsmType::kNone) continue;
      if (found.conflicts++ == 0) found.at = foot, found.element = mast.id.osm, found.obstacle = on;
    }
  return found;
}

AssumedTests measure_assumed_yards(const scene::Chunk& chunk, const ground::LandCoverIndex& land_cover,
                                   const Box2& box) {
  AssumedTests found;
  if (std::ranges::none_of(chunk.surfaces, ground::is_yard)) return found;
  for (const plants::Tree& tree : chunk.trees) {
    if (!is_derived(tree.id) || !box.contains_half_open(tree.at)) continue;
    ++found.tested;
    const OsmId on = no_place_for_tree(chunk, land_cover, tree.at);
    if (on.type != OsmType::kNone && found.conflicts++ == 0)
      found.at = tree.at, found.element = tree.id.osm, found.obstacle = on;
  }
  test_yard_places(chunk, land_cover, box, found);
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
        const OsmId on = taken_by(land_cover, p);
        if (on.type != OsmType::kNone && found.conflicts++ == 0)
          found.at = p, found.element = hedge.id.osm, found.obstacle = on;
      }
    }
  }
  return found;
}

AssumedTests measure_assumed_houses(const scene::Chunk& chunk, const ground::LandCoverIndex& land_cover,
                                    const Box2& box) {
  AssumedTests found;
  for (const buildings::Building& house : chunk.buildings) {
    if (house.id.osm.type != OsmType::kLot) continue;
    const Ring& ring = house.footprint.outer;
    const Vec2 middle = centroid(house.footprint);
    for (std::size_t i = 0; i < ring.size(); ++i)
      for (const Vec2 wall : {ring[i], (ring[i] + ring[(i + 1) % ring.size()]) * 0.5}) {
        const Vec2 p = wall + unit(middle - wall) * kInsideWall_m;
        if (!box.contains_half_open(p)) continue;
        ++found.tested;
        const OsmId on = no_place_for_house(chunk, land_cover, house.id.osm, p);
        if (on.type != OsmType::kNone && found.conflicts++ == 0)
          found.at = p, found.element = house.id.osm, found.obstacle = on;
      }
  }
  return found;
}

AssumedTests measure_assumed_fronts(const scene::Chunk& chunk) {
  AssumedTests found;
  for (const buildings::Building& building : chunk.buildings)
    for (const buildings::Front& front : building.fronts) {
      if (!front.is_assumed) continue;
      ++found.tested;
      if (is_on_free_wall(building, front)) continue;
      if (found.conflicts++ == 0)
        found.at = building.footprint.outer[front.edge % building.footprint.outer.size()],
        found.element = building.id.osm;
    }
  return found;
}

}  // namespace citykiln::verify
