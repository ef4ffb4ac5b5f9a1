#include "compiler/map/countries/country_group.h"

#include <array>
#include <cstddef>
#include <vector>

#include "compiler/geometry/polygon.h"

namespace citykiln::map {
namespace {

// A border of a group. x is the longitude, y the latitude.
struct GroupBorder {
  CountryGroup group;
  Ring ring;
};

const std::vector<GroupBorder>& group_borders() {
  static const std::vector<GroupBorder> all = {
#define COUNTRY_GROUP(group, ...) {CountryGroup::group, {__VA_ARGS__}},
#include "compiler/map/countries/country_groups.inc"
#undef COUNTRY_GROUP
  };
  return all;
}

}  // namespace

std::string_view name_of(CountryGroup group) {
  constexpr std::array<std::string_view, 14> kNames = {
      "central_europe", "southern_europe", "northern_europe", "eastern_europe",  "british_isles",
      "north_america",  "latin_america",   "middle_east",     "tropical_africa", "south_asia",
      "china",          "japan",           "south_east_asia", "oceania"};
  static_assert(kNames.size() == static_cast<std::size_t>(CountryGroup::kCount));
  return kNames[static_cast<std::size_t>(group)];
}

CountryGroup country_group_at(LonLat place) {
  // rings cover -180 to 180; the antimeridian is their western border
  const double lon_deg = place.lon_deg < 180 ? place.lon_deg : place.lon_deg - 360;
  for (const GroupBorder& border : group_borders())
    if (winding_number(border.ring, {lon_deg, place.lat_deg}) != 0) return border.group;
  return CountryGroup::kCentralEurope;
}

}  // namespace citykiln::map
