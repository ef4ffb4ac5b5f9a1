#include "compiler/map/countries/building_tradition.h"

#include <vector>

#include "compiler/geometry/polygon.h"

namespace citykiln::map {
namespace {

// A border of a tradition. x is the longitude, y the latitude.
struct TraditionBorder {
  BuildingTradition tradition;
  Ring ring;
};

const std::vector<TraditionBorder>& tradition_borders() {
  static const std::vector<TraditionBorder> all = {
#define BUILDING_TRADITION(tradition, ...) {BuildingTradition::tradition, {__VA_ARGS__}},
#include "compiler/map/countries/building_traditions.inc"
#undef BUILDING_TRADITION
  };
  return all;
}

}  // namespace

BuildingTradition building_tradition_at(LonLat place) {
  for (const TraditionBorder& border : tradition_borders())
    if (winding_number(border.ring, {place.lon_deg, place.lat_deg}) != 0) return border.tradition;
  return BuildingTradition::kOther;
}

}  // namespace citykiln::map
