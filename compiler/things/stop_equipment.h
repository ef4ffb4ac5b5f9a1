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

/// Returns the kinds that the tags of a thing ask for; none if it is no stop.
std::vector<std::string_view> kinds_at_stop(const map::ThingFeature& stop);

/// Returns the things of these kinds.
std::vector<map::ThingFeature> mapped_equipment(std::span<const map::ThingFeature> things);

/// Returns the equipment of a stop by ThingFeature::stop_has, with places and directions (ThingFeature::faces): a
/// shelter beside it, first along its right side, where its whole base is free; a bench, unless the shelter has one; a
/// basket. Equipment without a free place is left out. The kinds are "shelter", "bench" and "waste_basket", with their
/// usual sizes.
/// @param stop    A stop with equipment.
/// @param at      Where it stands.
/// @param facing  The way it faces, to the street; length 1.
/// @param mapped  Result of mapped_equipment().
std::vector<map::ThingFeature> equipment_of_stop(const map::ThingFeature& stop, Vec2 at, Vec2 facing,
                                                 std::span<const map::ThingFeature> mapped, FreePlaces& places);

}  // namespace citykiln::things
