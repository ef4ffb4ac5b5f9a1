#include "compiler/map/country_group.h"

#include <array>
#include <cstddef>

#include "compiler/map/road_guidelines.h"

namespace citykiln::map {

std::string_view name_of(CountryGroup group) {
  constexpr std::array<std::string_view, 14> kNames = {
      "central_europe", "southern_europe", "northern_europe", "eastern_europe",  "british_isles",
      "north_america",  "latin_america",   "middle_east",     "tropical_africa", "south_asia",
      "china",          "japan",           "south_east_asia", "oceania"};
  static_assert(kNames.size() == static_cast<std::size_t>(CountryGroup::kCount));
  return kNames[static_cast<std::size_t>(group)];
}

CountryGroup country_group_at(LonLat place) {
  switch (guidelines_at(place)) {
    case RoadGuidelines::kNorthAmerica:
      return CountryGroup::kNorthAmerica;
    case RoadGuidelines::kBritishIsles:
      return CountryGroup::kBritishIsles;
    case RoadGuidelines::kJapan:
      return CountryGroup::kJapan;
    default:
      return CountryGroup::kCentralEurope;
  }
}

}  // namespace citykiln::map
