// The equipment of stops of buses and trams by their tags: a shelter, a bench, a basket.
//
//     =====carriageway=====
//     ---------------------  kerb
//          o  [shelter   ]   o  the stop; the shelter beside it, away from the kerb
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "compiler/geometry/vec.h"
#include "compiler/map/features.h"
#include "compiler/things/free_places.h"

namespace citykiln::things {

/// Equipment that is mapped this near to a stop replaces that of its tags, in metres.
inline constexpr double kMappedEquipment_m = 25;

/// Returns the kinds of equipment that a stop is tagged with; none for other things.
std::vector<std::string_view> kinds_at_stop(const map::ThingFeature& stop);

/// Returns the shelters, benches and waste baskets among things.
std::vector<map::ThingFeature> mapped_equipment(std::span<const map::ThingFeature> things);

/// Returns the tagged equipment of a stop (ThingFeature::stop_has) with places and directions (ThingFeature::faces): a
/// shelter, a bench if no shelter was placed, since its mesh has one, and a waste basket. Each stands beside the stop,
/// first to the right as seen from the street, at most 2.5 m behind it, where nine points of its base are free.
/// Equipment without a free place is left out. Pieces of one stop are not tested against each other.
/// @param stop    A stop with equipment.
/// @param at      Where it stands.
/// @param facing  The direction that it faces, towards the street; length 1.
/// @param mapped  The result of mapped_equipment().
/// @param places  Free places on the land cover of the map; not thread-safe.
std::vector<map::ThingFeature> equipment_of_stop(const map::ThingFeature& stop, Vec2 at, Vec2 facing,
                                                 std::span<const map::ThingFeature> mapped, FreePlaces& places);

}  // namespace citykiln::things
