// The year as plants have it: what a month leaves of a species' looks.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "compiler/plants/species.h"

namespace citykiln::plants {

/// As the northern half of the Earth has it: 1 is January there, July in the south.
enum class Month : std::uint8_t {};
inline constexpr Month kMidsummer{6};

/// Of "2026-10-21T12:00" at a latitude. It is always midsummer between the tropics, and where the text tells no month.
Month month_for(std::string_view time, double latitude_deg);

/// As a multiple of what species_looks.inc tells, and linear reflectance in thousandths.
struct SeasonState {
  double leaf_share = 1;         ///< LeafForm that there are; 0: bare twigs.
  double young = 0, turned = 0;  ///< Shares of those colours in the leaves'.
  double height_share = 1;       ///< Of the plant's height; 0: nothing stands.
  std::array<int, 3> young_leaf{}, turned_leaf{};
};

/// years.inc. Variants of a species turn one after the other. Whole summer plants for who is evergreen, and in
/// midsummer.
SeasonState season_state_of(Prototype prototype, Month month);

}  // namespace citykiln::plants
