#include "compiler/cars/parked_cars.h"

#include <algorithm>
#include <span>
#include <tuple>

#include "compiler/cars/bay_places.h"
#include "compiler/cars/car_models.h"
#include "compiler/cars/has_ground.h"
#include "compiler/cars/occupancy.h"
#include "compiler/cars/street_places.h"
#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/snap.h"
#include "compiler/map/things/thing_role.h"
#include "compiler/roads/pieces/stretches.h"
#include "compiler/things/facing.h"

namespace citykiln::cars {
namespace {

using roadside::ClearZones;
using roadside::is_clear;
using roadside::TileRecipes;

// The share of the spare length of a place by which cars stand before or behind its middle.
constexpr double kMostShift = 0.6;
// Places of the tile overlap those up to this far outside.
constexpr double kOverlap_m = 8;
// Two rectangles overlap if they share more than this.
constexpr double kBorder_m = 0.0625;
// Draws of a place with a car.
enum : std::uint32_t { kDrawTurned, kDrawAlong, kDrawAskew };

// The stretches of a road with parking lanes; others do not need them.
std::vector<roads::RoadStretch> lane_stretches(const roads::Road& road,
                                               std::span<const roads::JunctionInterval> intervals, double tile_m) {
  const bool has_rows = std::ranges::any_of(road.section.lanes, [](const map::Lane& lane) {
    return lane.kind == map::LaneKind::kParking && !lane.is_raised;
  });
  if (!has_rows) return {};
  return roads::stretches_of(road, intervals, tile_m);
}

bool is_at_street(const Place& place) { return place.kind == PlaceKind::kLane || place.kind == PlaceKind::kKerb; }

std::vector<Place> all_places(const TileRecipes& recipes, const CarSettings& settings, const Box2& box) {
  std::vector<Place> places;
  const auto append = [&](const std::vector<Place>& more) {
    std::ranges::copy_if(more, std::back_inserter(places), [&](const Place& p) { return box.contains(p.at); });
  };
  const std::vector<std::vector<roads::JunctionInterval>> intervals =
      roads::junction_intervals_of(recipes.roads, recipes.junctions);
  for (std::size_t i = 0; i < recipes.roads.size(); ++i)
    append(places_along(recipes.roads[i], lane_stretches(recipes.roads[i], intervals[i], recipes.tile_m), box));
  for (const pitches::Pitch& pitch : recipes.pitches) append(places_in_bays(pitch, settings.country));
  for (const lots::Yard& yard : recipes.yards) append(places_on_drives(yard));
  for (const lots::Yard& plot : recipes.plots) append(places_on_plot(plot));
  for (const things::Thing& thing : recipes.things)
    if (map::role_of(thing.form.kind) == map::ThingRole::kCar) append({place_of_space(thing, settings.country)});
  return places;
}

// Drops places by what all tiles near them know, except mapped spaces.
void drop_unsuitable(const TileRecipes& recipes, const ClearZones& zones, std::vector<Place>& places) {
  std::erase_if(places, [&](const Place& place) {
    const OrientedRect rect = rect_of(place);
    return (is_at_street(place) && !is_clear(zones.streets, rect)) || !is_clear(zones.trunks, rect) ||
           !has_ground(place, recipes.land_cover);
  });
}

// True if of two places that overlap, the second of which is in the box, the first counts. Other tiles do not know the
// mapped spaces of this one.
bool counts_before(const Place& first, const Place& second, const Box2& box) {
  const bool is_space = first.kind == PlaceKind::kSpace;
  if (is_space == (second.kind == PlaceKind::kSpace))
    return std::tuple(first.kind, first.key, first.at) < std::tuple(second.kind, second.key, second.at);
  return box.contains_half_open(first.at) == is_space;
}

// The places of a box that overlap none that counts before them.
std::vector<Place> first_of_overlapping(const std::vector<Place>& places, const Box2& box) {
  std::vector<OrientedRect> rects;
  for (const Place& place : places) rects.push_back(rect_of(place));
  const RectIndex index = index_rects(std::move(rects));
  std::vector<Place> first;
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    if (!box.contains_half_open(places[i].at)) continue;
    const bool is_later = any_about(index.grid, box_of(index.all[i]), [&](std::uint32_t other) {
      return other != i && counts_before(places[other], places[i], box) &&
             overlap(index.all[other], index.all[i], kBorder_m);
    });
    if (!is_later) first.push_back(places[i]);
  }
  return first;
}

// Drops places by what this tile alone knows.
void drop_obstructed(const ClearZones& zones, std::vector<Place>& places) {
  std::erase_if(places, [&](const Place& place) {
    const OrientedRect rect = rect_of(place);
    return (is_at_street(place) && !is_clear(zones.stops, rect)) || !is_clear(zones.doors, rect) ||
           !is_clear(zones.barriers, rect) || overlaps_any(zones.things, rect, 0);
  });
}

// The largest sine of the angle at which a form stands askew: its corners stay in the place, in spite of the shift
// along it and of the rounding of directions.
double most_askew(const Place& place, const things::Form& form) {
  constexpr double kMostAskew = 0.0175, kRounding = 0.0031;
  const double beside_m = place.width_m - form.width_m, before_m = (place.length_m - form.depth_m) * (1 - kMostShift);
  return std::clamp(std::min(beside_m / form.depth_m, before_m / form.width_m) - kRounding, 0.0, kMostAskew);
}

things::Thing car_in(const Place& place, std::uint32_t number, std::uint64_t seed) {
  const RandomSequence draw(seed, place.key, "stance");
  things::Form form = form_of_car(place, seed);
  const bool is_turned = place.may_turn && draw.unit(kDrawTurned) < (place.kind == PlaceKind::kDrive ? 0.5 : 0.3);
  const double spare_m = std::max(0.0, place.length_m - form.depth_m) / 2 * kMostShift;
  const double askew = most_askew(place, form);
  const Vec2 at = place.at + place.ahead * draw.between(-spare_m, spare_m, kDrawAlong);
  const Vec2 ahead = place.ahead + left_of(place.ahead) * draw.between(-askew, askew, kDrawAskew);
  return {.id = {place.feature, number},
          .at = snapped(at),
          .direction = things::nearest_direction(is_turned ? ahead * -1.0 : ahead),
          .is_in_way = true,
          .form = std::move(form)};
}

}  // namespace

std::vector<Place> places_in(const TileRecipes& recipes, const ClearZones& zones, const CarSettings& settings,
                             const Box2& box) {
  std::vector<Place> places = all_places(recipes, settings, box.widened(kOverlap_m));
  drop_unsuitable(recipes, zones, places);
  std::ranges::sort(places, {}, [](const Place& p) { return std::tuple(p.kind, p.key, p.at); });
  places = first_of_overlapping(places, box);
  drop_obstructed(zones, places);
  return places;
}

std::vector<OrientedRect> taken_places(const TileRecipes& recipes, const ClearZones& zones, const CarSettings& settings,
                                       const Box2& box) {
  std::vector<OrientedRect> taken;
  if (!has_cars(settings.share)) return taken;
  std::vector<Place> places = all_places(recipes, settings, box);
  drop_unsuitable(recipes, zones, places);
  for (const Place& place : places)
    if (is_taken(place, settings.share, settings.time, settings.seed)) taken.push_back(rect_of(place));
  return taken;
}

std::vector<things::Thing> parked_cars(const TileRecipes& recipes, const ClearZones& zones, const CarSettings& settings,
                                       const Box2& box) {
  std::vector<things::Thing> cars;
  if (!has_cars(settings.share)) return cars;
  std::uint32_t number = 0;
  for (const Place& place : places_in(recipes, zones, settings, box)) {
    if (!is_taken(place, settings.share, settings.time, settings.seed)) continue;
    things::Thing car = car_in(place, number++, settings.seed);
    if (is_on_ground(roadside::plan_of(car), place, recipes.land_cover)) cars.push_back(std::move(car));
  }
  return cars;
}

}  // namespace citykiln::cars
