#include "compiler/cars/kept_clear.h"

#include <algorithm>
#include <string_view>

#include "compiler/buildings/planning/doors.h"
#include "compiler/geometry/line_part.h"
#include "compiler/geometry/segment.h"
#include "compiler/map/things/thing_role.h"
#include "compiler/roads/pieces/stretches.h"

namespace citykiln::cars {
namespace {

using roads::Arm;
using roads::Junction;
using roads::Road;

// Clear of the junctions of drives and service roads.
constexpr double kFromDrive_m = 1;
// A drive, and how far before its end at the street it stays free: a pavement, a verge and the row at the kerb.
constexpr double kHalfDrive_m = 1.625, kBeforeDrive_m = 9;
constexpr double kTrunk_m = 0.375, kThing_m = 0.25, kBarrier_m = 0.125;

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

// Crossings where they are marked: those near a junction are at its mouth.
void add_crossings(const Road& road, std::span<const roads::JunctionInterval> intervals, double tile_m,
                   std::vector<lots::Capsule>& clear) {
  if (road.points.empty()) return;
  const std::vector<double> along = roads::distances_along(road);
  for (const roads::RoadStretch& stretch : roads::stretches_of(road, intervals, tile_m)) {
    if (stretch.stretch != roads::StretchKind::kZebra && stretch.stretch != roads::StretchKind::kCrossing) continue;
    const Vec2 a = point_at(road.axis, along, stretch.from_m), b = point_at(road.axis, along, stretch.to_m);
    if (a != b) add_across(road, a, b, kFromCrossing_m, clear);
  }
  // mapped crossings of which the junction is not known
  for (const map::TrackPoint& point : road.points)
    if (point.kind == map::TrackPointKind::kZebra || point.kind == map::TrackPointKind::kCrossing)
      clear.push_back({road.axis[point.vertex], road.axis[point.vertex], kFromCrossing_m});
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

}  // namespace

bool is_clear(const lots::Capsules& kept, const Place& place) {
  if (kept.all.empty()) return true;
  const double half_m = place.width_m / 2;
  const Vec2 reach = place.ahead * std::max(0.0, place.length_m / 2 - half_m);
  return !any_about(kept.grid, box_of(place), [&](std::uint32_t i) {
    const lots::Capsule& near = kept.all[i];
    return distance_of_segments(place.at - reach, place.at + reach, near.a, near.b) < near.radius_m + half_m;
  });
}

std::vector<lots::Capsule> street_clearings(std::span<const Road> roads, std::span<const Junction> junctions,
                                            std::span<const lots::Yard> yards, double tile_m) {
  std::vector<lots::Capsule> clear;
  add_junctions(roads, junctions, clear);
  const std::vector<std::vector<roads::JunctionInterval>> intervals = roads::junction_intervals_of(roads, junctions);
  for (std::size_t i = 0; i < roads.size(); ++i)
    if (map::is_street(roads[i].surface)) add_crossings(roads[i], intervals[i], tile_m, clear);
  for (const lots::Yard& yard : yards) add_drives(yard, clear);
  return clear;
}

std::vector<lots::Capsule> stop_clearings(std::span<const things::Thing> things) {
  std::vector<lots::Capsule> clear;
  for (const things::Thing& thing : things)
    if (const double radius_m = stop_radius_m(thing.form.kind); radius_m > 0)
      clear.push_back({thing.at, thing.at, radius_m});
  return clear;
}

std::vector<lots::Capsule> trunk_clearings(std::span<const plants::Tree> trees) {
  std::vector<lots::Capsule> clear;
  for (const plants::Tree& tree : trees) clear.push_back({tree.at, tree.at, kTrunk_m});
  return clear;
}

std::vector<lots::Capsule> solid_clearings(std::span<const things::Thing> things,
                                           std::span<const props::Barrier> barriers,
                                           std::span<const buildings::Building> buildings) {
  std::vector<lots::Capsule> clear;
  for (const things::Thing& thing : things)
    if (!thing.foot_m && map::role_of(thing.form.kind) != map::ThingRole::kCar)
      clear.push_back({thing.at, thing.at, kThing_m});
  for (const props::Barrier& barrier : barriers)
    for (std::size_t i = 0; i + 1 < barrier.axis.size(); ++i)
      clear.push_back({barrier.axis[i], barrier.axis[i + 1], kBarrier_m + barrier.width_m / 2});
  for (const buildings::Building& building : buildings)
    for (const Vec2 door : buildings::door_positions(building)) clear.push_back({door, door, kFromDoor_m});
  return clear;
}

}  // namespace citykiln::cars
