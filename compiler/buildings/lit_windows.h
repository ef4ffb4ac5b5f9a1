// Decides which windows are lit at an hour, by the building's use and by household.
//
//     ┌───┬───┬───┬───┬───┬───┐   A unit (a flat, a guest room, an office) is a cell of the plan on one storey. Lamps
//     │ ▓ │ ▓ │   │   │ ▓ │   │   are on in it while its rank in [0, 1) is below the share of units in use, a function
//     ├───┴───┴───┼───┴───┴───┤   of the hour. While the share rises units only switch on, while it falls only off.
//     │  one flat │           │   Some rooms of a unit are lit whenever lamps are on in it, the others never.
//     └───────────┴───────────┘
#pragma once

#include <cstdint>
#include <optional>

#include "compiler/buildings/recipe.h"
#include "grammars/derivation/context_query.h"

namespace citykiln::buildings {

/// The use of a building: a row of lit_shares.inc.
enum class Use : std::uint8_t {
#define USE(name, unit_m, room_m, room_share, weekday, weekend) name,
#include "compiler/buildings/lit_shares.inc"
#undef USE
  kCount
};

/// Returns the use by the building's class, or by its style if the class does not imply a use.
Use use_of(const Building& building);

/// A time of the week: hours since Monday 0:00 local mean solar time.
struct WeekTime {
  double hours = 0;  ///< From 0 to 168.
};

/// Returns the share of a use's units in which lamps are on while it is dark, from 0 to 1. It is continuous and has a
/// period of a week.
double lit_share(Use use, WeekTime time);

/// Returns the share of windows that are lit, on average over many buildings of a use.
double lit_window_share(Use use, WeekTime time);

/// Returns a function that answers ContextQuery::kIsLit: true if the window at the middle of a shape's scope is lit.
/// O(1) per query.
/// @param building  Must outlive the function.
/// @param given     The share of units with lamps on, in place of lit_share(). All of their rooms are then lit.
grammars::AnswerContextQuery lit_windows(const Building& building, WeekTime time, std::uint64_t seed,
                                         std::optional<double> given = {});

/// True if lamps are on behind a shop front: during its hours (as tagged, else of its kind), and up to half an hour
/// before and three quarters after them. A share of the fronts, by kind, is lit from 15:00 to 23:30 on all days.
/// @param front  Index into building.fronts.
/// @param given  The share of fronts that are lit, in place of hours.
bool is_front_lit(const Building& building, std::uint32_t front, WeekTime time, std::uint64_t seed,
                  std::optional<double> given = {});

/// True if lamps are on in the shops of a building's ground floor.
bool is_shop_lit(const Building& building, WeekTime time, std::uint64_t seed, std::optional<double> given = {});

}  // namespace citykiln::buildings
