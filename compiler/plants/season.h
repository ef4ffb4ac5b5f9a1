// Seasons: the state of a species' leaves and its height in each month.
#pragma once

#include <cstdint>
#include <string_view>

#include "compiler/plants/species.h"

namespace citykiln::plants {

/// A month of the northern hemisphere's year, 1 to 12: 1 is January in the north and July in the south.
enum class Month : std::uint8_t {};
inline constexpr Month kMidsummer{6};

/// Returns the month of a time like "2026-10-21T12:00" at a latitude. Returns kMidsummer between the tropics, and for a
/// text without a month.
Month month_for(std::string_view time, double latitude_deg);

/// The state of a plant in a month.
struct SeasonState {
  double leaf_share = 1;         ///< The share of the leaves that are present; 0: bare twigs.
  double young = 0, turned = 0;  ///< The shares of the young and turned leaf colours in the leaf colour.
  double height_share = 1;       ///< The height as a share of the summer height; 0: no plant.
};

/// Returns the state of a prototype in a month, by the species' `months`. In a month of turning leaves, the turned
/// share differs between variants, the differently grown plants of the species.
SeasonState season_state_of(Prototype prototype, Month month);

}  // namespace citykiln::plants
