#include "compiler/roadside/clear_zones.h"

#include <algorithm>
#include <string_view>

#include "compiler/buildings/planning/doors.h"
#include "compiler/geometry/line_part.h"
#include "compiler/geometry/segment.h"
#include "compiler/map/things/thing_role.h"
#include "compiler/roads/pieces/stretches.h"
#include "compiler/things/facing.h"

namespace citykiln::roadside {
namespace {

using roads::Arm;
using roads::Junction;
using roads::Road;

// A drive, and how far before its end at the street it stays free: a pavement, a verge and the row at the kerb.
constexpr double kHalfDrive_m = 1.625, kBeforeDrive_m = 9;
constexpr double kTrunk_m = 0.375, kBarrier_m = 0.125;
// A mapped crossing this near to a painted one is that one: crossings near a junction move to its mouth.
constexpr double kSameCrossing_m = 12;

double distance_of_segments(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  if (crossing_shares(a, b, c, d)) return 0;
  return std::min({distance_to_segment(c, d, a), distance_to_segment(c, d, b), distance_to_segment(a, b, c),
                   distance_to_segment(a, b, d)});
}

// A point of an arm's axis and the kerbs beside it.
void add_across(const Road& road, Vec2 a, Vec2 b, double radius_m, std::vector<lots::Capsule>& clear) {
  const Vec2 left = left_of(unit(b - a));
  for (const double off_m : {0.0, roads::left_m(road), -roads::right_m(road)})
    clear.push_back({a + left * off_m, b + left * off_m, radius_m});
}

// The part of an arm in its junction.
void add_arm(const Road& road, const Arm& arm, const roads::Cut& cut, double radius_m,
             std::vector<lots::Capsule>& clear) {
  const std::vector<double> along = roads::distances_along(road);
  const double node_m = along[arm.vertex];
  const double length_m = cut.length_m == roads::kWholeLink_m ? 0 : cut.length_m;
  const double end_m = std::clamp(node_m + arm.step * length_m, along.front(), along.back());
  const Vec2 node = road.axis[arm.vertex], end = point_at(road.axis, along, end_m);
  add_across(road, node, node == end ? node + Vec2{kQuantum_m, 0} : end, radius_m, clear);
}

void add_junctions(std::span<const Road> roads, std::span<const Junction> junctions,
                   std::vector<lots::Capsule>& clear) {
  const std::vector<std::vector<Arm>> arms = roads::arms_of(junctions, roads);
  for (std::size_t j = 0; j < junctions.size(); ++j) {
    if (junctions[j].family != roads::Family::kStreet || arms[j].size() != junctions[j].cuts.size()) continue;
    const auto streets =
        std::ranges::count_if(arms[j], [&](const Arm& arm) { return roads::is_through_street(roads[arm.road]); });
    const double radius_m = streets > 2 ? kFromJunction_m : kFromDrive_m;
    for (std::size_t a = 0; a < arms[j].size(); ++a)
      add_arm(roads[arms[j][a].road], arms[j][a], junctions[j].cuts[a], radius_m, clear);
  }
}

// Crossings where they are painted. A tile that does not know the junction beside a mapped one, and so does not know
// where it is painted, keeps the mapped place clear.
void add_crossings(const Road& road, std::span<const roads::JunctionInterval> intervals, double tile_m,
                   std::vector<lots::Capsule>& clear) {
  if (road.points.empty()) return;
  const std::vector<double> along = roads::distances_along(road);
  std::vector<roads::RoadStretch> painted = roads::stretches_of(road, intervals, tile_m);
  std::erase_if(painted, [](const roads::RoadStretch& stretch) {
    return stretch.stretch != roads::StretchKind::kZebra && stretch.stretch != roads::StretchKind::kCrossing;
  });
  for (const roads::RoadStretch& crossing : painted) {
    const Vec2 a = point_at(road.axis, along, crossing.from_m), b = point_at(road.axis, along, crossing.to_m);
    if (a != b) add_across(road, a, b, kFromCrossing_m, clear);
  }
  for (const map::TrackPoint& point : road.points) {
    if (point.kind != map::TrackPointKind::kZebra && point.kind != map::TrackPointKind::kCrossing) continue;
    const double at_m = along[point.vertex];
    const bool is_painted = std::ranges::any_of(painted, [&](const roads::RoadStretch& crossing) {
      return crossing.from_m - kSameCrossing_m < at_m && at_m < crossing.to_m + kSameCrossing_m;
    });
    if (!is_painted) clear.push_back({road.axis[point.vertex], road.axis[point.vertex], kFromCrossing_m});
  }
}

void add_drives(const lots::Yard& yard, std::vector<lots::Capsule>& clear) {
  const lots::Frame frame = lots::frame_at(yard.frame);
  for (const lots::YardStrip& strip : yard.strips) {
    if (!strip.is_drive) continue;
    const Vec2 end = frame.plane(strip.from.y <= strip.to.y ? strip.from : strip.to);
    clear.push_back({end, end - frame.inward * kBeforeDrive_m, kHalfDrive_m});
  }
}

double stop_radius_m(std::string_view kind) {
  if (kind == "bus_stop" || kind == "tram_stop") return kFromStop_m;
  if (kind == "fire_hydrant" || kind == "hydrant_sign") return kFromHydrant_m;
  return kind.ends_with("gate") ? kFromGate_m : 0;
}

std::vector<lots::Capsule> street_zones(const TileRecipes& recipes) {
  std::vector<lots::Capsule> clear;
  add_junctions(recipes.roads, recipes.junctions, clear);
  const std::vector<std::vector<roads::JunctionInterval>> intervals =
      roads::junction_intervals_of(recipes.roads, recipes.junctions);
  for (std::size_t i = 0; i < recipes.roads.size(); ++i)
    if (map::is_street(recipes.roads[i].surface)) add_crossings(recipes.roads[i], intervals[i], recipes.tile_m, clear);
  for (const lots::Yard& yard : recipes.yards) add_drives(yard, clear);
  return clear;
}

std::vector<lots::Capsule> stop_zones(std::span<const things::Thing> things) {
  std::vector<lots::Capsule> clear;
  for (const things::Thing& thing : things)
    if (const double radius_m = stop_radius_m(thing.form.kind); radius_m > 0)
      clear.push_back({thing.at, thing.at, radius_m});
  return clear;
}

std::vector<lots::Capsule> barrier_zones(std::span<const props::Barrier> barriers) {
  std::vector<lots::Capsule> clear;
  for (const props::Barrier& barrier : barriers) {
    if (barrier.kind == map::BarrierKind::kKerb) continue;
    for (std::size_t i = 0; i + 1 < barrier.axis.size(); ++i)
      clear.push_back({barrier.axis[i], barrier.axis[i + 1], kBarrier_m + barrier.width_m / 2});
  }
  return clear;
}

std::vector<lots::Capsule> disks(std::span<const Vec2> places, double radius_m) {
  std::vector<lots::Capsule> disks;
  for (const Vec2 p : places) disks.push_back({p, p, radius_m});
  return disks;
}

std::vector<Vec2> doors_of(std::span<const buildings::Building> buildings) {
  std::vector<Vec2> doors;
  for (const buildings::Building& building : buildings)
    for (const Vec2 door : buildings::door_positions(building)) doors.push_back(door);
  return doors;
}

std::vector<Vec2> feet_of(std::span<const props::StreetLamp> lamps) {
  std::vector<Vec2> feet;
  for (const props::StreetLamp& lamp : lamps) feet.push_back(lamp.at);
  return feet;
}

std::vector<OrientedRect> plans_of(std::span<const things::Thing> things) {
  std::vector<OrientedRect> plans;
  for (const things::Thing& thing : things)
    if (!thing.foot_m && thing.form.height_m >= kLowThing_m && map::role_of(thing.form.kind) != map::ThingRole::kCar)
      plans.push_back(plan_of(thing));
  return plans;
}

}  // namespace

ClearZones clear_zones_of(const TileRecipes& recipes) {
  return {.streets = lots::index_capsules(street_zones(recipes)),
          .trunks = lots::index_capsules(disks(recipes.trunks, kTrunk_m)),
          .stops = lots::index_capsules(stop_zones(recipes.things)),
          .doors = lots::index_capsules(disks(doors_of(recipes.buildings), kFromDoor_m)),
          .barriers = lots::index_capsules(barrier_zones(recipes.barriers)),
          .lamps = lots::index_capsules(disks(feet_of(recipes.lamps), kFromLamp_m)),
          .things = index_rects(plans_of(recipes.things))};
}

bool is_clear(const lots::Capsules& zones, const OrientedRect& rect) {
  if (zones.all.empty()) return true;
  const double half_m = std::min(rect.length_m, rect.width_m) / 2;
  const Vec2 longer = rect.length_m >= rect.width_m ? rect.ahead : left_of(rect.ahead);
  const Vec2 reach = longer * (std::max(rect.length_m, rect.width_m) / 2 - half_m);
  return !any_about(zones.grid, box_of(rect), [&](std::uint32_t i) {
    const lots::Capsule& near = zones.all[i];
    return distance_of_segments(rect.at - reach, rect.at + reach, near.a, near.b) < near.radius_m + half_m;
  });
}

OrientedRect plan_of(const things::Thing& thing) {
  return {.at = thing.at,
          .ahead = things::unit_vector(thing.direction),
          .length_m = thing.form.depth_m,
          .width_m = thing.form.width_m};
}

}  // namespace citykiln::roadside
