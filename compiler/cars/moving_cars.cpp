#include "compiler/cars/moving_cars.h"

#include <algorithm>

#include "compiler/cars/car_models.h"
#include "compiler/cars/has_ground.h"
#include "compiler/geometry/snap.h"
#include "compiler/things/facing.h"

namespace citykiln::cars {
namespace {

using roadside::is_clear;
using roadside::TileRecipes;

// Places overlap those up to this far outside the tile: half a bus and half a car.
constexpr double kReach_m = 10;
// The numbers of parked cars among the things of a tile are below this.
constexpr std::uint32_t kFirstMoving = 1U << 20;

std::vector<LanePlace> places_near(const TileRecipes& recipes, const TrafficSettings& settings, const Box2& box) {
  std::vector<LanePlace> places;
  const std::vector<std::vector<roads::JunctionInterval>> intervals =
      roads::junction_intervals_of(recipes.roads, recipes.junctions);
  for (std::size_t i = 0; i < recipes.roads.size(); ++i) {
    const roads::Road& road = recipes.roads[i];
    if (!box_of(road.axis).widened(kReach_m).touches(box)) continue;
    std::ranges::copy(
        lane_places(road, intervals[i], roads::stretches_of(road, intervals[i], recipes.tile_m), settings, box),
        std::back_inserter(places));
  }
  std::erase_if(places, [&](const LanePlace& p) { return !has_ground(p.place, recipes.land_cover); });
  std::ranges::sort(places, {}, [](const LanePlace& p) { return std::pair(p.place.key, p.place.at); });
  return places;
}

// The places of a box that overlap none with a lower key.
std::vector<LanePlace> first_of_lanes(const std::vector<LanePlace>& places, const Box2& box) {
  std::vector<OrientedRect> rects;
  for (const LanePlace& place : places) rects.push_back(rect_of(place.place));
  const RectIndex index = index_rects(std::move(rects));
  std::vector<LanePlace> first;
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    if (!box.contains_half_open(places[i].place.at)) continue;
    const bool is_later = any_about(index.grid, box_of(index.all[i]), [&](std::uint32_t other) {
      return other < i && overlap(index.all[other], index.all[i], 0);
    });
    if (!is_later) first.push_back(places[i]);
  }
  return first;
}

things::Form form_in(const LanePlace& place, std::uint64_t seed) {
  if (place.user == LaneUser::kBus) return form_of_bus(place.place, seed);
  return place.user == LaneUser::kLorry ? form_of_lorry(place.place, seed) : form_of_car(place.place, seed);
}

}  // namespace

std::vector<things::Thing> moving_cars(const TileRecipes& recipes, const roadside::ClearZones& zones,
                                       const TrafficSettings& settings, const CarSettings& parked, const Box2& box) {
  std::vector<things::Thing> cars;
  if (!has_cars(settings.share)) return cars;
  std::vector<LanePlace> places = places_near(recipes, settings, box.widened(kReach_m));
  const RectIndex taken = index_rects(taken_places(recipes, zones, parked, box.widened(kReach_m)));
  std::erase_if(places, [&](const LanePlace& p) { return overlaps_any(taken, rect_of(p.place), 0); });
  std::uint32_t number = 0;
  for (const LanePlace& place : first_of_lanes(places, box)) {
    const OrientedRect rect = rect_of(place.place);
    if (!is_clear(zones.barriers, rect) || overlaps_any(zones.things, rect, 0)) continue;
    cars.push_back({.id = {place.place.feature, kFirstMoving + number++},
                    .at = snapped(place.place.at),
                    .direction = things::nearest_direction(place.place.ahead),
                    .is_in_way = true,
                    .form = form_in(place, settings.seed)});
  }
  return cars;
}

}  // namespace citykiln::cars
