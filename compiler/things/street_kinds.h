// The kinds of things that are assumed along streets: furniture on pavements, and utility poles.
#pragma once

#include <algorithm>
#include <string_view>

#include "compiler/map/countries/country_group.h"
#include "compiler/map/things/thing_table.h"

namespace citykiln::things {

/// A row of street_kinds.inc. Name, facing and size repeat the row of things.txt for things without tags.
struct StreetKind {
  std::string_view name;
  map::Facing facing;
  double width_m, depth_m, height_m;
  double beside_shops_per_km, beside_houses_per_km;  ///< Pieces per km of one pavement; the sums are below 125.
};

inline constexpr StreetKind kStreetKinds[] = {
#define STREET_KIND(name, facing, ...) {name, map::Facing::facing, __VA_ARGS__},
#include "compiler/things/street_kinds.inc"
#undef STREET_KIND
};

/// The row of things.txt for utility poles.
inline constexpr std::string_view kUtilityPole = "power_pole";

/// A row of utility_poles.inc.
struct UtilityPoleShare {
  map::CountryGroup country;
  int main_percent, other_percent;  ///< Shares of secondary and tertiary streets, of residential streets.
};

inline constexpr UtilityPoleShare kUtilityPoleShares[] = {
#define UTILITY_POLES(country, main_percent, other_percent) {map::CountryGroup::country, main_percent, other_percent},
#include "compiler/things/utility_poles.inc"
#undef UTILITY_POLES
};

/// Returns the row of a country group; nullptr if its streets have no poles.
constexpr const UtilityPoleShare* utility_pole_share(map::CountryGroup country) {
  const auto* const row = std::ranges::find(kUtilityPoleShares, country, &UtilityPoleShare::country);
  return row == std::end(kUtilityPoleShares) ? nullptr : row;
}

/// True if a kind of things is assumed along streets.
constexpr bool is_street_kind(std::string_view name) {
  return name == kUtilityPole || std::ranges::find(kStreetKinds, name, &StreetKind::name) != std::end(kStreetKinds);
}

}  // namespace citykiln::things
