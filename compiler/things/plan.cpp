#include "compiler/things/plan.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <map>
#include <optional>
#include <span>
#include <tuple>

#include "compiler/contract/joined.h"
#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/snap.h"
#include "compiler/map/things/thing_role.h"
#include "compiler/things/facing.h"
#include "compiler/things/free_places.h"
#include "compiler/things/front_kinds.h"
#include "compiler/things/guard_rails.h"
#include "compiler/things/junction_signals.h"
#include "compiler/things/on_roofs.h"
#include "compiler/things/stop_equipment.h"
#include "compiler/things/street_kinds.h"
#include "compiler/things/yard_kinds.h"

namespace citykiln::things {
namespace {

// A thing on a wall stands off it by this much, so that their faces do not coincide.
constexpr double kOffWall_m = 0.02;

bool has_way(const map::ThingFeature& thing) { return thing.way.id.osm.type != OsmType::kNone; }

// Where a thing stands, and the direction that it faces.
struct Stance {
  Vec2 at, facing;
};

// Nodes of a road stand on the side of the traffic that they are for, nodes of a path on its right.
std::optional<Vec2> beside_way(const map::ThingFeature& thing, double radius_m, FreePlaces& places) {
  const Vec2 left = left_of(traffic_of(thing));
  const Vec2 out = thing.way.side == map::DrivingSide::kLeft ? left : left * -1.0;
  if (const auto place = places.first_free(thing.at, out, radius_m)) return place;
  return places.first_free(thing.at, out * -1.0, radius_m);
}

std::optional<Stance> on_wall(const map::ThingFeature& thing, FreePlaces& places) {
  const double before_m = thing.depth_m / 2 + kOffWall_m;
  const std::optional<WallPlace> wall = places.nearest_wall(thing.at, before_m);
  if (!wall) return std::nullopt;
  return Stance{snapped(wall->at + wall->out * before_m), wall->out};
}

std::optional<Vec2> place_of(const map::ThingFeature& thing, const map::ThingRow& row, FreePlaces& places) {
  if (thing.is_in_way) return thing.at;
  const bool is_on_axis = has_way(thing) && !places.is_free(thing.at, 0);
  return is_on_axis ? beside_way(thing, row.clear_m, places) : places.nearest_free(thing.at, row.clear_m);
}

// The foot of a thing that is mapped on a building and may stand there.
std::optional<FootOnRoof> foot_of(const map::ThingFeature& thing, map::Stand stand, const Roofs& roofs) {
  const bool may_be_there = stand == map::Stand::kRoof || stand == map::Stand::kThroughRoof || thing.is_on_roof;
  if (!may_be_there) return std::nullopt;
  const auto below = roofs.below(thing.at, std::min(thing.width_m, thing.depth_m) / 2);
  return below ? std::optional(foot_on_roof(thing, stand, *below)) : std::nullopt;
}

bool reads(const Kind& kind, std::string_view attribute) { return kind.used.attributes.contains(attribute); }

// Mapped parking spaces have a kind alone: their cars are drawn when a tile is baked (cars/parked_cars.h).
Form form_of(const map::ThingFeature& thing, const Kind& kind, std::uint64_t seed) {
  if (map::role_of(thing.kind) == map::ThingRole::kCar) return {.kind = thing.kind};
  Form form{.kind = thing.kind, .width_m = thing.width_m, .depth_m = thing.depth_m, .height_m = thing.height_m};
  if (reads(kind, "kind")) form.value = thing.value;
  if (reads(kind, "material")) form.material = thing.material;
  if (reads(kind, "text")) form.text = thing.text;
  if (reads(kind, "colour")) form.colour = thing.colour;
  if (reads(kind, "capacity")) form.capacity = thing.capacity;
  if (reads(kind, "country")) form.country = thing.country;
  if (kind.used.draws)
    form.variant = static_cast<std::uint8_t>(RandomSequence(seed, stable_id(thing.id), "variant").below(kVariants, 0));
  return form;
}

// A thing with a place and a direction of its own.
Thing thing_at(const map::ThingFeature& thing, const Kind& kind, std::uint64_t seed) {
  return {.id = thing.id,
          .at = thing.at,
          .direction = nearest_direction(thing.faces.value_or(Vec2{0, -1})),
          .is_in_way = false,
          .form = form_of(thing, kind, seed)};
}

std::optional<Stance> stance_of(const map::ThingFeature& thing, const map::ThingRow& row, const Axes& axes,
                                FreePlaces& places, std::uint64_t seed) {
  if (row.stand == map::Stand::kWall)
    if (const auto stance = on_wall(thing, places)) return stance;
  if (thing.faces) {
    const bool may_stand = thing.is_in_way || places.is_free(thing.at, 0);
    return may_stand ? std::optional(Stance{thing.at, *thing.faces}) : std::nullopt;
  }
  const std::optional<Vec2> at = place_of(thing, row, places);
  if (!at) return std::nullopt;
  return Stance{*at, facing_of(thing, row.facing, *at, axes, seed)};
}

bool is_for_arms(const map::ThingFeature& thing, const Kinds& kinds) {
  return kinds.find(thing.kind)->second.row.facing == map::Facing::kArms;
}

// The roads and their junctions.
struct Network {
  std::span<const roads::Road> roads;
  std::span<const roads::Junction> junctions;
};

// The things, with those of Facing::kArms for each arm of their junctions.
std::vector<map::ThingFeature> with_derived(const map::FeatureView& features, const Network& network,
                                            const Kinds& kinds) {
  std::vector<map::ThingFeature> things;
  std::map<std::string, std::vector<map::ThingFeature>> on_arms;
  for (const map::ThingFeature& thing : features.things)
    (is_for_arms(thing, kinds) ? on_arms[thing.kind] : things).push_back(thing);
  for (auto& [kind, mapped] : on_arms)
    std::ranges::move(with_one_for_each_arm(mapped, network.roads, network.junctions), std::back_inserter(things));
  return things;
}

// Counts the things on the map as in, and the difference to these as split or merged.
void count_derived(const map::FeatureView& features, const std::vector<map::ThingFeature>& things, const Report& report,
                   Account& account) {
  const auto counted = [&](std::span<const map::ThingFeature> all) {
    return std::ranges::count_if(all, [&](const map::ThingFeature& thing) { return report.counts(thing.id.osm); });
  };
  const auto before = counted(features.things), after = counted(things);
  account.in += static_cast<std::uint64_t>(before);
  (after > before ? account.split : account.merged) += static_cast<std::uint64_t>(std::abs(after - before));
}

// The manifest of a map without pavements has no rules of street furniture.
bool has_pavements(std::span<const roads::Road> roads) {
  const auto is_pavement = [](const map::Lane& lane) { return lane.kind == map::LaneKind::kSidewalk; };
  return std::ranges::any_of(
      roads, [&](const roads::Road& road) { return std::ranges::any_of(road.section.lanes, is_pavement); });
}

// The kinds that may be assumed before fronts and in streets for walkers.
std::set<std::string> kinds_in_centres(std::span<const roads::Road> roads,
                                       std::span<const buildings::Building> buildings) {
  std::set<std::string> names;
  for (const buildings::Building& building : buildings)
    for (const buildings::Front& front : building.fronts)
      for (const FrontThingKind& kind : kFrontThings)
        if (kind.front == front.kind) names.emplace(kind.name);
  const auto is_walked = [](const roads::Road& road) { return road.surface == map::LandCoverClass::kPedestrianStreet; };
  if (std::ranges::any_of(roads, is_walked)) names.emplace(kBollard), names.emplace(kPlanter);
  return names;
}

// True if an island is mapped: refuges stand there.
bool has_islands(std::span<const roads::Road> roads) {
  const auto is_island = [](const map::TrackPoint& point) {
    return point.kind == map::TrackPointKind::kIsland || (point.traits & map::kCrossingIsland) != 0;
  };
  return std::ranges::any_of(roads,
                             [&](const roads::Road& road) { return std::ranges::any_of(road.points, is_island); });
}

// The kinds that may be assumed along roads.
std::set<std::string> assumed_kinds(std::span<const roads::Road> roads) {
  std::set<std::string> names;
  if (has_pavements(roads))
    for (const StreetKind& kind : kStreetKinds) names.emplace(kind.name);
  const auto may_have_poles = [](const roads::Road& road) { return utility_pole_share(road.country) != nullptr; };
  if (std::ranges::any_of(roads, may_have_poles)) names.emplace(kUtilityPole);
  return names;
}

}  // namespace

std::set<std::string> kind_names(const map::FeatureView& features, const map::ThingTable& table) {
  std::set<std::string> names;
  const bool has_streets =
      std::ranges::any_of(features.tracks, [](const map::Track& track) { return map::is_street(track.surface); });
  for (const map::ThingRow& row : table)
    if (has_streets && map::role_of(row.name) == map::ThingRole::kCar) names.insert(row.name);
  for (const map::ThingFeature& thing : features.things) {
    names.insert(thing.kind);
    for (const std::string_view kind : kinds_at_stop(thing)) names.emplace(kind);
  }
  for (const map::ThingFeature& thing : features.supports_beyond) names.insert(thing.kind);
  return names;
}

std::vector<Thing> plan_mapped(const map::FeatureView& features, std::span<const roads::Road> roads,
                               std::span<const roads::Junction> junctions,
                               std::span<const ground::LandCoverPolygon> cover,
                               std::span<const buildings::Building> buildings, const Kinds& kinds, std::uint64_t seed,
                               Report& report) {
  const Axes axes = axes_of(roads);
  FreePlaces places(cover);
  const Roofs roofs(buildings);
  std::vector<Thing> things;
  Account account;
  const std::vector<map::ThingFeature> all = with_derived(features, {roads, junctions}, kinds);
  count_derived(features, all, report, account);
  const std::vector<map::ThingFeature> at_stops = mapped_equipment(all);
  for (map::ThingFeature thing : all) {
    const Kind& kind = kinds.find(thing.kind)->second;
    const map::ThingRow& row = kind.row;
    const bool counts = report.counts(thing.id.osm);
    const std::optional<FootOnRoof> on_roof = foot_of(thing, row.stand, roofs);
    if (!on_roof && thing.is_on_roof) {
      report.drop(account, Code::kAboveGround, thing.id.osm);
      continue;
    }
    if (on_roof) thing.height_m = on_roof->height_m, thing.is_in_way = true;
    const std::optional<Stance> stance = stance_of(thing, row, axes, places, seed);
    if (!stance) {
      report.drop(account, {Code::kNoPlaceForThing, thing.id.osm, 0, {}, {}, row.name});
      continue;
    }
    if (!features.extent.contains(stance->at)) {
      report.drop(account, Code::kOutsideBounds, thing.id.osm);
      continue;
    }
    account.out += counts;
    things.push_back({.id = thing.id,
                      .at = stance->at,
                      .direction = nearest_direction(stance->facing),
                      .is_in_way = thing.is_in_way,
                      .form = form_of(thing, kind, seed),
                      .foot_m = on_roof ? on_roof->foot_m : std::nullopt});
    if (thing.stop_has == 0) continue;
    for (const map::ThingFeature& each : equipment_of_stop(thing, stance->at, stance->facing, at_stops, places)) {
      const auto kind_of_each = kinds.find(each.kind);
      if (kind_of_each == kinds.end() || !features.extent.contains(each.at)) continue;
      account.split += counts, account.out += counts;
      things.push_back(thing_at(each, kind_of_each->second, seed));
    }
  }
  std::ranges::sort(things, {}, &Thing::id);
  report.account("things", "thing") = account;
  return things;
}

std::vector<Thing> plan_supports_beyond(const map::FeatureView& features, const Kinds& kinds, std::uint64_t seed) {
  const Axes no_axes = axes_of({});
  std::vector<Thing> supports;
  for (const map::ThingFeature& thing : features.supports_beyond) {
    const auto kind = kinds.find(thing.kind);
    if (kind == kinds.end()) continue;
    const Vec2 facing = facing_of(thing, kind->second.row.facing, thing.at, no_axes, seed);
    supports.push_back({.id = thing.id,
                        .at = thing.at,
                        .direction = nearest_direction(facing),
                        .form = form_of(thing, kind->second, seed)});
  }
  std::ranges::sort(supports, {}, &Thing::id);
  return supports;
}

Result<ThingPlan> plan(const map::FeatureView& features, const ThingInputs& inputs, Report& report) {
  const auto& [catalogue, equipment, cover, roads, junctions, bridges, buildings, ground, assumed, seed] = inputs;
  ThingPlan plan;
  if (has(assumed, Assumption::kRailings))
    plan.railings = assumed_railings(
        features, {.cover = cover, .roads = roads, .bridges = bridges, .buildings = buildings, .ground = ground},
        report);
  if (has(assumed, Assumption::kRoadsides))
    plan.railings = joined(std::move(plan.railings), assumed_guard_rails(features, roads, ground, report),
                           [](const props::Barrier& b) { return std::tie(b.id, b.axis); });
  plan.mapped.assign(features.things.begin(), features.things.end());
  plan.mapped.insert(plan.mapped.end(), equipment.begin(), equipment.end());
  map::FeatureView seen = features;
  seen.things = plan.mapped;
  if (has(assumed, Assumption::kMasts))
    plan.contact_lines =
        plan_contact_lines(seen, {.cover = cover, .roads = roads, .bridges = bridges, .ground = ground}, report);
  std::erase_if(plan.mapped, [&](const auto& thing) { return plan.contact_lines.replaced.contains(thing.id.osm); });
  seen.things = plan.mapped;
  std::set<std::string> names = kind_names(seen, catalogue.table);
  for (const Thing& mast : plan.contact_lines.masts) names.insert(mast.form.kind);
  if (has(assumed, Assumption::kRoadsides)) names.merge(assumed_kinds(roads));
  if (has(assumed, Assumption::kRoadsides)) names.merge(kinds_in_centres(roads, buildings));
  if (has_islands(roads)) names.emplace(kRefuge);
  if (has(assumed, Assumption::kYards) && !buildings.empty()) {
    for (const YardKind& kind : kYardKinds) names.emplace(kind.name);
    names.emplace(kYardGate);
  }
  if (!names.empty()) {
    Result<Kinds> kinds = kinds_of(catalogue, names);
    if (!kinds) return kinds.error();
    plan.kinds = std::move(*kinds);
    plan.things = joined(plan_mapped(seen, roads, junctions, cover, buildings, plan.kinds, seed, report),
                         plan.contact_lines.masts, [](const Thing& thing) { return std::tie(thing.id, thing.at); });
  }
  plan.beyond = plan_supports_beyond(seen, plan.kinds, seed);
  return plan;
}

}  // namespace citykiln::things
