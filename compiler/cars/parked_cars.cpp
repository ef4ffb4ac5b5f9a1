#include "compiler/cars/parked_cars.h"

#include <algorithm>
#include <tuple>

#include "compiler/cars/bay_places.h"
#include "compiler/cars/car_models.h"
#include "compiler/cars/has_ground.h"
#include "compiler/cars/occupancy.h"
#include "compiler/cars/street_places.h"
#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/snap.h"
#include "compiler/map/things/thing_role.h"
#include "compiler/things/facing.h"

namespace citykiln::cars {
namespace {

// Places of the tile overlap those up to this far outside.
constexpr double kOverlap_m = 8;
// Draws of a place with a car.
enum : std::uint32_t { kDrawTurned, kDrawAlong, kDrawAskew };

bool is_at_street(const Place& place) { return place.kind == PlaceKind::kLane || place.kind == PlaceKind::kKerb; }

std::vector<Place> all_places(const TileRecipes& recipes, const CarWish& wish, const Box2& box) {
  std::vector<Place> places;
  const auto append = [&](const std::vector<Place>& more) {
    std::ranges::copy_if(more, std::back_inserter(places), [&](const Place& p) { return box.contains(p.at); });
  };
  for (const roads::Road& road : recipes.roads) append(places_along(road, box));
  for (const pitches::Pitch& pitch : recipes.pitches) append(places_in_bays(pitch, wish.country));
  for (const lots::Yard& yard : recipes.yards) append(places_on_drives(yard));
  for (const things::Thing& thing : recipes.things)
    if (map::role_of(thing.form.kind) == map::ThingRole::kCar) append({place_of_space(thing, wish.country)});
  return places;
}

// The half extent of a place in a direction.
double reach_m(const Place& place, Vec2 direction) {
  return std::abs(dot(place.ahead, direction)) * place.length_m / 2 +
         std::abs(cross(place.ahead, direction)) * place.width_m / 2;
}

// True if two rectangles share more than a border.
bool overlap(const Place& a, const Place& b) {
  constexpr double kBorder_m = 0.0625;
  for (const Vec2 axis : {a.ahead, left_of(a.ahead), b.ahead, left_of(b.ahead)})
    if (std::abs(dot(b.at - a.at, axis)) >= reach_m(a, axis) + reach_m(b, axis) - kBorder_m) return false;
  return true;
}

// The places of sorted ones that overlap no earlier one.
std::vector<Place> first_of_overlapping(const std::vector<Place>& places, const Box2& box) {
  std::vector<Box2> boxes;
  for (const Place& place : places) boxes.push_back(box_of(place));
  if (boxes.empty()) return {};
  const BoxGrid grid = grid_of(boxes, 16);
  std::vector<Place> first;
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    if (!box.contains_half_open(places[i].at)) continue;
    const bool is_later =
        any_about(grid, boxes[i], [&](std::uint32_t other) { return other < i && overlap(places[other], places[i]); });
    if (!is_later) first.push_back(places[i]);
  }
  return first;
}

things::Thing car_in(const Place& place, std::uint32_t number, std::uint64_t seed) {
  constexpr double kMostAskew = 0.0175, kMostShift = 0.6;
  const RandomSequence draw(seed, place.key, "stance");
  things::Form form = form_of_car(place, seed);
  const bool is_turned = place.may_turn && draw.unit(kDrawTurned) < (place.kind == PlaceKind::kDrive ? 0.5 : 0.3);
  const double spare_m = std::max(0.0, place.length_m - form.depth_m) / 2 * kMostShift;
  const Vec2 at = place.at + place.ahead * draw.between(-spare_m, spare_m, kDrawAlong);
  const Vec2 ahead = place.ahead + left_of(place.ahead) * draw.between(-kMostAskew, kMostAskew, kDrawAskew);
  return {.id = {place.feature, number},
          .at = snapped(at),
          .direction = things::nearest_direction(is_turned ? ahead * -1.0 : ahead),
          .is_in_way = true,
          .form = std::move(form)};
}

}  // namespace

std::vector<Place> places_in(const TileRecipes& recipes, const CarWish& wish, const Box2& box) {
  std::vector<Place> places = all_places(recipes, wish, box.widened(kOverlap_m));
  const lots::Capsules street =
      lots::index_capsules(street_clearings(recipes.roads, recipes.junctions, recipes.yards, wish.tile_m));
  const lots::Capsules trunks = lots::index_capsules(trunk_clearings(recipes.trees));
  std::erase_if(places, [&](const Place& place) {
    return (is_at_street(place) && !is_clear(street, place)) || !is_clear(trunks, place) ||
           !has_ground(place, recipes.land_cover);
  });
  std::ranges::sort(places, {}, [](const Place& p) { return std::tuple(p.kind, p.key, p.at); });
  places = first_of_overlapping(places, box);
  const lots::Capsules stops = lots::index_capsules(stop_clearings(recipes.things));
  const lots::Capsules solid =
      lots::index_capsules(solid_clearings(recipes.things, recipes.barriers, recipes.buildings));
  std::erase_if(places, [&](const Place& place) {
    return (is_at_street(place) && !is_clear(stops, place)) || !is_clear(solid, place);
  });
  return places;
}

std::vector<things::Thing> parked_cars(const TileRecipes& recipes, const CarWish& wish, const Box2& box) {
  std::vector<things::Thing> cars;
  if (!has_cars(wish.share)) return cars;
  std::uint32_t number = 0;
  for (const Place& place : places_in(recipes, wish, box))
    if (is_taken(place, wish.share, wish.time, wish.seed)) cars.push_back(car_in(place, number++, wish.seed));
  return cars;
}

}  // namespace citykiln::cars
