#include "compiler/things/stop_equipment.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "compiler/geometry/snap.h"

namespace citykiln::things {
namespace {

// A kind of equipment, its size, and the distance of its middle from the stop along the pavement.
struct Equipment {
  map::StopEquipment bit;
  std::string_view kind;
  double width_m, depth_m, height_m, aside_m;
};
constexpr Equipment kShelter{map::kStopShelter, "shelter", 4, 1.5, 2.5, 2.75},
    kBench{map::kStopBench, "bench", 1.8, 0.65, 0.85, 1.75}, kBasket{map::kStopBin, "waste_basket", 0.4, 0.45, 1, 0.75};

// Equipment may be this far behind the stop; places are tried in these steps.
constexpr double kFarthestBehind_m = 2.5, kBehindStep_m = 0.25;
// The disc about each place of a base that must be free.
constexpr double kFree_m = 0.125;

bool is_mapped_near_stop(std::string_view kind, Vec2 at, std::span<const map::ThingFeature> mapped) {
  return std::ranges::any_of(mapped, [&](const map::ThingFeature& thing) {
    return thing.kind == kind && distance(thing.at, at) < kMappedEquipment_m;
  });
}

// True if the base is free at nine places.
bool has_free_base(const Equipment& equipment, Vec2 at, Vec2 right, FreePlaces& places) {
  for (const double x : {-0.5, 0.0, 0.5})
    for (const double y : {-0.5, 0.0, 0.5})
      if (!places.is_free(at + right * (x * equipment.width_m) + left_of(right) * (y * equipment.depth_m), kFree_m))
        return false;
  return true;
}

// The first free place: on the right side of the stop from the kerb on, then on its left.
std::optional<Vec2> free_place_beside(const Equipment& equipment, Vec2 stop, Vec2 facing, FreePlaces& places) {
  const Vec2 right = left_of(facing);
  for (const double side : {1.0, -1.0})
    for (double behind_m = equipment.depth_m / 2; behind_m <= kFarthestBehind_m; behind_m += kBehindStep_m) {
      const Vec2 at = stop + right * (side * equipment.aside_m) - facing * behind_m;
      if (has_free_base(equipment, at, right, places)) return snapped(at);
    }
  return std::nullopt;
}

map::ThingFeature feature_of(const Equipment& equipment, const map::ThingFeature& stop, Vec2 at, Vec2 facing,
                             std::uint32_t part) {
  return {.id = {stop.id.osm, part},
          .at = at,
          .kind = std::string(equipment.kind),
          .value = {},
          .width_m = snapped(equipment.width_m),
          .depth_m = snapped(equipment.depth_m),
          .height_m = snapped(equipment.height_m),
          .country = stop.country,
          .faces = facing};
}

constexpr std::array<Equipment, 3> kAllEquipment = {kShelter, kBench, kBasket};

}  // namespace

std::vector<std::string_view> kinds_at_stop(const map::ThingFeature& stop) {
  std::vector<std::string_view> kinds;
  for (const Equipment& equipment : kAllEquipment)
    if ((stop.stop_has & equipment.bit) != 0) kinds.push_back(equipment.kind);
  return kinds;
}

std::vector<map::ThingFeature> mapped_equipment(std::span<const map::ThingFeature> things) {
  std::vector<map::ThingFeature> mapped;
  for (const map::ThingFeature& thing : things)
    if (std::ranges::any_of(kAllEquipment, [&](const Equipment& e) { return e.kind == thing.kind; }))
      mapped.push_back(thing);
  return mapped;
}

std::vector<map::ThingFeature> equipment_of_stop(const map::ThingFeature& stop, Vec2 at, Vec2 facing,
                                                 std::span<const map::ThingFeature> mapped, FreePlaces& places) {
  std::vector<map::ThingFeature> equipment;
  const auto add = [&](const Equipment& wanted, std::uint32_t part) {
    if ((stop.stop_has & wanted.bit) == 0 || is_mapped_near_stop(wanted.kind, at, mapped)) return false;
    const std::optional<Vec2> place = free_place_beside(wanted, at, facing, places);
    if (place) equipment.push_back(feature_of(wanted, stop, *place, facing, part));
    return place.has_value();
  };
  // the shelter has a bench of its own
  if (!add(kShelter, 1)) add(kBench, 2);
  add(kBasket, 3);
  return equipment;
}

}  // namespace citykiln::things
