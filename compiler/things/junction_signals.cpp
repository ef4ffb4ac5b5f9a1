#include "compiler/things/junction_signals.h"

#include <algorithm>
#include <map>

#include "compiler/geometry/snap.h"

namespace citykiln::things {
namespace {

using map::ThingFeature;

// The stop line is this far before the junction begins.
constexpr double kBeforeJunction_m = 1;

bool is_for_motors(const map::Lane& lane) { return lane.kind == map::LaneKind::kDriving; }

// The number of lanes on which traffic comes in.
std::uint16_t lanes_in(const roads::Road& road, const roads::Arm& arm) {
  const map::LaneDirection in = arm.step > 0 ? map::LaneDirection::kBackward : map::LaneDirection::kForward;
  const auto lanes = std::ranges::count_if(road.section.lanes, [&](const map::Lane& lane) {
    return is_for_motors(lane) && (lane.way == in || lane.way == map::LaneDirection::kBoth);
  });
  return static_cast<std::uint16_t>(lanes);
}

// The things of one kind: those on nodes of junctions by place, and the others.
struct Mapped {
  std::map<Vec2, ThingFeature> at_junctions;
  std::vector<ThingFeature> others;
};

Mapped sorted_by_junctions(std::vector<ThingFeature> things, std::span<const roads::Junction> junctions) {
  std::vector<Vec2> nodes;
  for (const roads::Junction& junction : junctions)
    nodes.insert(nodes.end(), junction.nodes.begin(), junction.nodes.end());
  std::ranges::sort(nodes);
  Mapped mapped;
  for (ThingFeature& thing : things)
    if (std::ranges::binary_search(nodes, thing.at))
      mapped.at_junctions.emplace(thing.at, std::move(thing));
    else
      mapped.others.push_back(std::move(thing));
  return mapped;
}

// The things on the nodes of a junction.
std::vector<const ThingFeature*> things_in(const roads::Junction& junction, const Mapped& mapped) {
  std::vector<const ThingFeature*> things;
  for (const Vec2 node : junction.nodes)
    if (const auto found = mapped.at_junctions.find(node); found != mapped.at_junctions.end())
      things.push_back(&found->second);
  return things;
}

const ThingFeature& nearest(const std::vector<const ThingFeature*>& things, Vec2 p) {
  return **std::ranges::min_element(things, {}, [&](const ThingFeature* thing) { return distance(thing->at, p); });
}

bool has_own(const std::vector<ThingFeature>& things, const roads::Road& road, const roads::Arm& arm) {
  const Vec2 node = road.axis[arm.vertex];
  const Vec2 out = road.axis[arm.vertex + static_cast<std::size_t>(arm.step)] - node;
  return std::ranges::any_of(things, [&](const ThingFeature& thing) {
    return thing.way.id.osm == road.id.osm && distance(thing.at, node) <= kSignalBefore_m &&
           dot(thing.at - node, out) > 0;
  });
}

ThingFeature thing_on_arm(const ThingFeature& mapped, std::span<const roads::Road> roads, const roads::Arm& arm,
                          double taken_m) {
  const Polyline out = roads::arm_axis(roads, arm, taken_m + kBeforeJunction_m);
  const roads::Road& road = roads[arm.road];
  ThingFeature thing = mapped;
  thing.at = snapped(out.back());
  thing.bearing_deg.reset(), thing.facing = 0;
  thing.capacity = lanes_in(road, arm);
  if (thing.capacity > 1) {
    thing.width_m = 2 * kReachPerLane_m * (std::min<int>(thing.capacity, kMostLanes) + 0.25);
    thing.height_m = kTallSignal_m;
  }
  thing.text = road.side == map::DrivingSide::kLeft ? "left" : "";
  thing.way = {.id = road.id,
               .along = unit(out[out.size() - 2] - out.back()),
               .surface = road.surface,
               .side = road.side,
               .is_oneway = true};  // for the traffic along it
  return thing;
}

// Appends the things of the arms of a junction.
void add_things_on_arms(const roads::Junction& junction, std::span<const roads::Road> roads,
                        std::span<const roads::Arm> arms, const Mapped& mapped, std::vector<ThingFeature>& all) {
  const std::vector<const ThingFeature*> here = things_in(junction, mapped);
  if (here.empty() || arms.size() != junction.cuts.size()) return;
  std::map<ObjectId, std::uint32_t> parts;
  for (std::size_t a = 0; a < arms.size(); ++a) {
    const roads::Road& road = roads[arms[a].road];
    const Vec2 node = road.axis[arms[a].vertex];
    const double taken_m = junction.cuts[a].length_m;
    const bool is_inside = taken_m == roads::kWholeLink_m;
    if (is_inside || lanes_in(road, arms[a]) == 0 || has_own(mapped.others, road, arms[a])) continue;
    ThingFeature thing = thing_on_arm(nearest(here, node), roads, arms[a], taken_m);
    thing.id.part = ++parts[thing.id];
    all.push_back(std::move(thing));
  }
}

}  // namespace

std::vector<ThingFeature> with_one_for_each_arm(std::span<const ThingFeature> things,
                                                std::span<const roads::Road> roads,
                                                std::span<const roads::Junction> junctions) {
  const Mapped mapped = sorted_by_junctions({things.begin(), things.end()}, junctions);
  if (mapped.at_junctions.empty()) return mapped.others;
  std::vector<ThingFeature> all = mapped.others;
  const std::vector<std::vector<roads::Arm>> arms = roads::arms_of(junctions, roads);
  for (std::size_t j = 0; j < junctions.size(); ++j) add_things_on_arms(junctions[j], roads, arms[j], mapped, all);
  return all;
}

}  // namespace citykiln::things
