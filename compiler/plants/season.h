// Seasons: the state of a species' leaves and its height in each month.
#pragma once

#include <chrono>
#include <cstdint>
#include <string_view>

#include "compiler/climate/climate_class.h"
#include "compiler/plants/species.h"

namespace citykiln::plants {

/// A month of the year in central Europe, 1 to 12. The plants of a place look as those of central Europe do in this
/// month, which need not be the month of the place's calendar. In the tropics it is always kMidsummer
/// (climate::equivalent_month).
enum class Month : std::uint8_t {};
/// June, in which all species are in their summer state.
inline constexpr Month kMidsummer{6};

/// Returns a month of the calendar as that of the northern hemisphere, by the sign of the latitude: December in the
/// south is June.
climate::LocalMonth local_month_of(std::chrono::month month, double latitude_deg);

/// Returns the month of central Europe in which plants look as those of a climate do in a month.
Month month_for(climate::LocalMonth month, climate::ClimateClass climate);

/// The state of a plant in a month.
struct SeasonState {
  double leaf_share = 1;         ///< The share of the leaves that are present; 0: bare twigs.
  double young = 0, turned = 0;  ///< The shares of the young and turned leaf colours in the leaf colour.
  double height_share = 1;       ///< The height as a share of the summer height; 0: no plant.
};

/// True for a text of 12 characters, each a known state of a month from January on, with "s" (summer) for June.
/// user_species.md lists the states.
bool are_months(std::string_view months);

/// Returns the state of a variant of a species in a month, by the species' `months`.
SeasonState season_state_of(const SpeciesValues& species, std::uint8_t variant, Month month);

/// Returns the state of a prototype of a shipped species in a month, by the species' `months`. In a month of turning
/// leaves, the turned share differs between variants, the differently grown plants of the species.
SeasonState season_state_of(Prototype prototype, Month month);

}  // namespace citykiln::plants
