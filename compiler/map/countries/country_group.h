// Chooses the group of countries whose practice of building a place follows.
#pragma once

#include <cstdint>
#include <string_view>

#include "compiler/map/plane/plane.h"

namespace citykiln::map {

/// Countries that build alike. The order is part of the manifest's format: append only.
enum class CountryGroup : std::uint8_t {
  kCentralEurope,
  kSouthernEurope,
  kNorthernEurope,
  kEasternEurope,
  kBritishIsles,
  kNorthAmerica,
  kLatinAmerica,
  kNorthAfricaAndMiddleEast,
  kTropicalAfrica,
  kSouthAsia,
  kChina,
  kJapan,
  kSouthEastAsia,
  kOceania,
  kCount
};

/// The name of a group in rule files and outputs, such as "southern_europe".
std::string_view name_of(CountryGroup group);

/// Returns the group by the rings of country_groups.inc; central Europe outside of all rings. Land borders are accurate
/// to about 30 km; at sea they lie anywhere between the coasts. France is divided at 45 degrees north, where roofs of
/// low round tiles begin; South Tyrol and Ticino build as central Europe does. Longitudes of 180 and more are taken
/// minus 360. O(rings).
CountryGroup country_group_at(LonLat place);

}  // namespace citykiln::map
