// A residential street with houses beside it, for tests of parking places.
#pragma once

#include <vector>

#include "compiler/cars/moving_cars.h"
#include "compiler/cars/parked_cars.h"
#include "compiler/roads/junctions/junction.h"

namespace citykiln::cars {

inline ground::LandCoverPolygon made_cover(std::int64_t id, const Box2& box, map::LandCoverClass surface) {
  return {{{OsmType::kWay, id}, 0}, surface, 0, {{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}}};
}

// A street of two lanes along an axis, 7 m wide, at whose right kerb cars may park.
inline roads::Road made_street(std::int64_t id, Polyline axis) {
  using map::LaneDirection;
  using map::LaneKind;
  roads::Road road;
  road.id = {{OsmType::kWay, id}, 0};
  road.axis = std::move(axis);
  road.surface = map::LandCoverClass::kResidentialRoad;
  road.section.lanes = {{LaneKind::kDriving, LaneDirection::kBackward, 3.5},
                        {LaneKind::kDriving, LaneDirection::kForward, 3.5}};
  road.section.axis_offset_m = 3.5;
  road.kerb_parking = map::kRightSide;
  road.country = map::CountryGroup::kSouthernEurope;
  return road;
}

// The recipes of a tile, with an index of their land cover.
struct MadeTile {
  std::vector<roads::Road> roads;
  std::vector<roads::Junction> junctions{};
  std::vector<ground::LandCoverPolygon> cover{};
  std::vector<lots::Yard> yards{};
  std::vector<lots::Yard> plots{};
  std::vector<pitches::Pitch> pitches{};
  std::vector<things::Thing> things{};
  std::vector<buildings::Building> buildings{};
  std::vector<props::Barrier> barriers{};

  std::vector<Vec2> trunks{};

  std::vector<Place> places(const Box2& box, std::uint64_t seed = 1) const {
    const ground::LandCoverIndex index = ground::index_land_cover(cover, box.widened(48));
    const roadside::TileRecipes tile = recipes(index);
    return places_in(tile, roadside::clear_zones_of(tile), settings(seed), box);
  }
  std::vector<things::Thing> cars(const Box2& box, CarShare share, std::uint64_t seed = 1) const {
    const ground::LandCoverIndex index = ground::index_land_cover(cover, box.widened(48));
    const roadside::TileRecipes tile = recipes(index);
    CarSettings wanted = settings(seed);
    wanted.share = share;
    return parked_cars(tile, roadside::clear_zones_of(tile), wanted, box);
  }
  std::vector<things::Thing> traffic(const Box2& box, CarShare share, CarShare parked = kNoCars) const {
    const ground::LandCoverIndex index = ground::index_land_cover(cover, box.widened(48));
    const roadside::TileRecipes tile = recipes(index);
    CarSettings wanted = settings(1);
    wanted.share = parked;
    return moving_cars(tile, roadside::clear_zones_of(tile), {share, {60}, 1}, wanted, box);
  }

 private:
  roadside::TileRecipes recipes(const ground::LandCoverIndex& index) const {
    return {.roads = roads,
            .junctions = junctions,
            .yards = yards,
            .plots = plots,
            .pitches = pitches,
            .trunks = trunks,
            .things = things,
            .lamps = {},
            .barriers = barriers,
            .buildings = buildings,
            .land_cover = index,
            .tile_m = 256};
  }
  static CarSettings settings(std::uint64_t seed) {
    return {.share = kUsualCars, .time = {60}, .country = map::CountryGroup::kCentralEurope, .seed = seed};
  }
};

// A street along y = 0 from x = 0 to 250, with houses 12 m south of it.
inline MadeTile street_tile() {
  MadeTile tile{.roads = {made_street(7, {{0, 0}, {250, 0}})}};
  tile.cover = {made_cover(7, {{0, -3.5}, {250, 3.5}}, map::LandCoverClass::kResidentialRoad),
                made_cover(8, {{0, -25}, {250, -12}}, map::LandCoverClass::kBuilding)};
  return tile;
}

inline const Box2 kMadeBox{{-64, -128}, {320, 128}};

}  // namespace citykiln::cars
