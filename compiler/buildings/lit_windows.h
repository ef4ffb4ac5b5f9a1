// Which windows are lit at an hour: by the building's use and by household.
//
//     ┌───┬───┬───┬───┬───┬───┐   A unit (a flat, a guest room, an office) is a cell of the plan on one storey. Lamps
//     │ ▓ │ ▓ │   │   │ ▓ │   │   are on in it while its rank in [0, 1) is below the share of units in use, a function
//     ├───┴───┴───┼───┴───┴───┤   of the hour. While the share rises units only switch on, while it falls only off.
//     │  one flat │           │   Some rooms of a unit are lit whenever lamps are on in it, the others never.
//     └───────────┴───────────┘
#pragma once

#include <cstdint>

#include "compiler/buildings/recipe.h"
#include "grammars/derivation/occlusion.h"

namespace citykiln::buildings {

/// What a building is used for: rows of lit_shares.inc.
enum class Use : std::uint8_t {
#define USE(name, unit_m, room_m, room_share, weekday, weekend) name,
#include "compiler/buildings/lit_shares.inc"
#undef USE
  kCount
};

/// By the building's class, where that does not say it by its style.
Use use_of(const Building& building);

/// Hours since Monday 0:00 local mean solar time.
struct WeekTime {
  double hours = 0;  ///< From 0 to 168.
};

/// The share of a use's units in which lamps are on while it is dark, from 0 to 1; continuous, and the same a week
/// later.
double lit_share(Use use, WeekTime time);

/// The share of a building's windows that is lit, on average over many buildings of its use.
double lit_window_share(Use use, WeekTime time);

/// Answers kIsLit for the middle of a shape's scope. @param building  Must outlive the answer. O(1).
grammars::Occlusion lit_windows(const Building& building, WeekTime time, std::uint64_t seed);

/// Whether lamps are on in the shops of a building's ground floor.
bool is_shop_lit(const Building& building, WeekTime time, std::uint64_t seed);

}  // namespace citykiln::buildings
