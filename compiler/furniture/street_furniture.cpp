#include "compiler/furniture/street_furniture.h"

#include <algorithm>
#include <iterator>

#include "compiler/cars/kept_clear.h"
#include "compiler/contract/random_sequence.h"
#include "compiler/furniture/stations.h"
#include "compiler/geometry/snap.h"
#include "compiler/things/facing.h"
#include "compiler/things/street_kinds.h"

namespace citykiln::furniture {
namespace {

using things::StreetKind;

enum class Use { kNone, kHouses, kShops };

// The middles of shop fronts.
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

std::vector<lots::Capsule> lamp_clearings(std::span<const props::StreetLamp> lamps) {
  std::vector<lots::Capsule> clear;
  for (const props::StreetLamp& lamp : lamps) clear.push_back({lamp.at, lamp.at, kFromLamp_m});
  return clear;
}

// The place that a piece covers; cars and furniture keep the same distances.
cars::Place place_of(const Station& station, const StreetKind& kind) {
  return {.key = station.key,
          .at = station.kerb + station.outward * (kBehindKerb_m + kind.depth_m / 2),
          .ahead = left_of(station.outward),
          .length_m = kind.width_m,
          .width_m = kind.depth_m};
}

struct Furnisher {
  const StreetRecipes& recipes;
  std::uint64_t seed;
  const Box2& box;
  lots::Capsules streets, solid, lamps, fronts;

  Use use_at(const Station& station) const {
    const cars::Place point{.at = station.kerb, .ahead = station.outward};
    if (!is_clear(fronts, point)) return Use::kShops;
    const int buildings = map::values_of(map::LandCoverClass::kBuilding).priority;
    const bool is_beside =
        recipes.land_cover.box.contains(station.kerb) &&
        ground::clearance_m(recipes.land_cover, station.kerb, buildings, kBesideHouse_m) < kBesideHouse_m;
    return is_beside ? Use::kHouses : Use::kNone;
  }

  // The kind that the station draws by the rates of its use, if it draws one.
  const StreetKind* drawn(const Station& station, Use use) const {
    if (use == Use::kNone) return nullptr;
    double rank = RandomSequence(seed, station.key, "furniture").unit(0) * 1000 / kStationStep_m;
    for (const StreetKind& kind : things::kStreetKinds) {
      rank -= use == Use::kShops ? kind.beside_shops_per_km : kind.beside_houses_per_km;
      if (rank < 0) return &kind;
    }
    return nullptr;
  }

  bool lies_on_pavement(const cars::Place& place) const {
    const auto is_pavement = [&](Vec2 p) {
      const std::uint32_t top =
          recipes.land_cover.box.contains(p) ? ground::land_cover_at(recipes.land_cover, p) : ground::kNoLandCover;
      return top != ground::kNoLandCover && recipes.land_cover.surfaces[top].surface == map::LandCoverClass::kPavement;
    };
    return is_pavement(place.at) && std::ranges::all_of(corners_of(place), is_pavement);
  }

  bool is_mapped_near(const StreetKind& kind, Vec2 at) const {
    return std::ranges::any_of(recipes.things, [&](const things::Thing& thing) {
      return thing.form.kind == kind.name && distance(thing.at, at) < kNoneNearMapped_m;
    });
  }

  bool may_stand(const Station& station, const StreetKind& kind) const {
    if (station.room_m < kBehindKerb_m + kind.depth_m + kFreeWidth_m) return false;
    const cars::Place place = place_of(station, kind);
    return box.contains_half_open(place.at) && lies_on_pavement(place) && is_clear(streets, place) &&
           is_clear(solid, place) && is_clear(lamps, place) && !is_mapped_near(kind, place.at);
  }

  things::Thing piece(const Station& station, const StreetKind& kind, const roads::Road& road,
                      std::uint32_t number) const {
    return {.id = {road.id.osm, number},
            .at = snapped(place_of(station, kind).at),
            .direction = things::nearest_direction(station.outward),
            .form = {.kind = std::string(kind.name),
                     .width_m = snapped(kind.width_m),
                     .depth_m = snapped(kind.depth_m),
                     .height_m = snapped(kind.height_m),
                     .country = road.country}};
  }
};

// Clearings that furniture shares with parked cars.
std::vector<lots::Capsule> solid_of(const StreetRecipes& recipes) {
  std::vector<lots::Capsule> solid = cars::solid_clearings(recipes.things, {}, recipes.buildings);
  for (const lots::Capsule& trunk : cars::trunk_clearings(recipes.trees)) solid.push_back(trunk);
  return solid;
}

}  // namespace

std::vector<things::Thing> street_furniture(const StreetRecipes& recipes, std::uint64_t seed, double tile_m,
                                            const Box2& box) {
  const Furnisher furnisher{
      .recipes = recipes,
      .seed = seed,
      .box = box,
      .streets = lots::index_capsules(cars::street_clearings(recipes.roads, recipes.junctions, recipes.yards, tile_m)),
      .solid = lots::index_capsules(solid_of(recipes)),
      .lamps = lots::index_capsules(lamp_clearings(recipes.lamps)),
      .fronts = lots::index_capsules(fronts_of(recipes.buildings))};
  std::vector<things::Thing> pieces;
  for (const roads::Road& road : recipes.roads)
    for (const Station& station : stations_along(road, box, kStationStep_m)) {
      const StreetKind* kind = furnisher.drawn(station, furnisher.use_at(station));
      if (kind && furnisher.may_stand(station, *kind))
        pieces.push_back(furnisher.piece(station, *kind, road, static_cast<std::uint32_t>(pieces.size())));
    }
  return pieces;
}

}  // namespace citykiln::furniture
