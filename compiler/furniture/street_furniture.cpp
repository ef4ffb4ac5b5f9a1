#include "compiler/furniture/street_furniture.h"

#include <algorithm>
#include <iterator>

#include "compiler/contract/random_sequence.h"
#include "compiler/furniture/stations.h"
#include "compiler/geometry/snap.h"
#include "compiler/things/facing.h"
#include "compiler/things/street_kinds.h"

namespace citykiln::furniture {
namespace {

using roadside::ClearZones;
using roadside::is_clear;
using roadside::TileRecipes;
using things::StreetKind;

enum class Use { kNone, kHouses, kShops };

// Shop fronts, and the pavements before them.
std::vector<lots::Capsule> fronts_of(std::span<const buildings::Building> buildings) {
  std::vector<lots::Capsule> fronts;
  for (const buildings::Building& building : buildings)
    for (const buildings::Front& front : building.fronts) {
      const Ring& ring = building.footprint.outer;
      if (front.edge >= ring.size()) continue;
      const Vec2 a = ring[front.edge], along = unit(ring[(front.edge + 1) % ring.size()] - a);
      fronts.push_back({a + along * front.from_m, a + along * front.to_m, kBesideFront_m});
    }
  return fronts;
}

// The number that a station draws, which counts down the rates of the kinds.
double rank_of(const Station& station, std::uint64_t seed) {
  return RandomSequence(seed, station.key, "furniture").unit(0) * 1000 / kStationStep_m;
}

const StreetKind* kind_of_rank(double rank, Use use) {
  if (use == Use::kNone) return nullptr;
  for (const StreetKind& kind : things::kStreetKinds) {
    rank -= use == Use::kShops ? kind.beside_shops_per_km : kind.beside_houses_per_km;
    if (rank < 0) return &kind;
  }
  return nullptr;
}

struct RoadStation {
  const roads::Road* road;
  Station station;
};

// The stations that draw a kind beside shops or beside houses. All tiles know these, but not the shops of each other.
std::vector<RoadStation> drawing_stations(std::span<const roads::Road> roads, std::uint64_t seed, const Box2& box) {
  std::vector<RoadStation> drawing;
  for (const roads::Road& road : roads)
    for (const Station& station : stations_along(road, box, kStationStep_m)) {
      const double rank = rank_of(station, seed);
      if (kind_of_rank(rank, Use::kShops) || kind_of_rank(rank, Use::kHouses)) drawing.push_back({&road, station});
    }
  return drawing;
}

// Drops stations near one with a lower key, even if that one is dropped itself.
std::vector<RoadStation> apart(const std::vector<RoadStation>& stations) {
  constexpr double kBucket_m = 16;
  if (stations.empty()) return {};
  std::vector<Box2> boxes;
  for (const RoadStation& each : stations)
    boxes.push_back(Box2{each.station.inner_edge, each.station.inner_edge}.widened(kStationsApart_m));
  const BoxGrid grid = grid_of(boxes, kBucket_m);
  std::vector<RoadStation> first;
  std::ranges::copy_if(stations, std::back_inserter(first), [&](const RoadStation& each) {
    const Vec2 at = each.station.inner_edge;
    return std::ranges::none_of(boxes_about(grid, at), [&](std::uint32_t i) {
      const Station& other = stations[i].station;
      return other.key < each.station.key && distance(other.inner_edge, at) < kStationsApart_m;
    });
  });
  return first;
}

// How a piece stands at a station.
struct Stance {
  OrientedRect plan;  // ahead is the direction that it faces
  double room_m = 0;  // the width of pavement that it takes, from the inner edge
};

Stance stance_of(const Station& station, const StreetKind& kind) {
  constexpr double kHalfPole_m = 0.1;
  const bool is_along = kind.facing == map::Facing::kAlong;
  const double across_m = is_along ? kind.width_m : kind.depth_m, middle_m = kBehindKerb_m + across_m / 2;
  return {.plan = {.at = snapped(station.inner_edge + station.outward * middle_m),
                   .ahead = (is_along ? station.traffic : station.outward) * -1.0,
                   .length_m = kind.depth_m,
                   .width_m = kind.width_m},
          .room_m = middle_m + (is_along ? kHalfPole_m : across_m / 2)};
}

struct Furnisher {
  const TileRecipes& recipes;
  const ClearZones& zones;
  const Box2& box;
  lots::Capsules fronts;

  Use use_at(Vec2 p) const {
    if (lots::clearance_m(fronts, p, kBesideFront_m) < 0) return Use::kShops;
    const int buildings = map::values_of(map::LandCoverClass::kBuilding).priority;
    const bool is_beside = recipes.land_cover.box.contains(p) &&
                           ground::clearance_m(recipes.land_cover, p, buildings, kBesideHouse_m) < kBesideHouse_m;
    return is_beside ? Use::kHouses : Use::kNone;
  }

  bool lies_on_pavement(const OrientedRect& plan) const {
    const auto is_pavement = [&](Vec2 p) {
      const std::uint32_t top =
          recipes.land_cover.box.contains(p) ? ground::land_cover_at(recipes.land_cover, p) : ground::kNoLandCover;
      return top != ground::kNoLandCover && recipes.land_cover.surfaces[top].surface == map::LandCoverClass::kPavement;
    };
    return is_pavement(plan.at) && std::ranges::all_of(corners_of(plan), is_pavement);
  }

  bool is_mapped_near(const StreetKind& kind, Vec2 at) const {
    return std::ranges::any_of(recipes.things, [&](const things::Thing& thing) {
      return thing.form.kind == kind.name && distance(thing.at, at) < kNoneNearMapped_m;
    });
  }

  bool may_stand(const Station& station, const Stance& stance, const StreetKind& kind) const {
    const OrientedRect& plan = stance.plan;
    if (station.room_m < stance.room_m + kFreeWidth_m || !box.contains_half_open(plan.at)) return false;
    return lies_on_pavement(plan) && is_clear(zones.streets, plan) && is_clear(zones.trunks, plan) &&
           is_clear(zones.doors, plan) && is_clear(zones.lamps, plan) && !overlaps_any(zones.things, plan, 0) &&
           !is_mapped_near(kind, plan.at);
  }
};

things::Thing piece_of(const OrientedRect& plan, const StreetKind& kind, const roads::Road& road,
                       std::uint32_t number) {
  return {.id = {road.id.osm, number},
          .at = plan.at,
          .direction = things::nearest_direction(plan.ahead),
          .form = {.kind = std::string(kind.name),
                   .width_m = snapped(kind.width_m),
                   .depth_m = snapped(kind.depth_m),
                   .height_m = snapped(kind.height_m),
                   .country = road.country}};
}

}  // namespace

std::vector<things::Thing> street_furniture(const TileRecipes& recipes, const ClearZones& zones, std::uint64_t seed,
                                            const Box2& box) {
  const Furnisher furnisher{recipes, zones, box, lots::index_capsules(fronts_of(recipes.buildings))};
  std::vector<things::Thing> pieces;
  for (const auto& [road, station] : apart(drawing_stations(recipes.roads, seed, box))) {
    const StreetKind* kind = kind_of_rank(rank_of(station, seed), furnisher.use_at(station.inner_edge));
    if (kind == nullptr) continue;
    const Stance stance = stance_of(station, *kind);
    if (furnisher.may_stand(station, stance, *kind))
      pieces.push_back(piece_of(stance.plan, *kind, *road, static_cast<std::uint32_t>(pieces.size())));
  }
  return pieces;
}

}  // namespace citykiln::furniture
