#include "compiler/map/road_guidelines.h"

#include <vector>

#include "compiler/geometry/polygon.h"

namespace citykiln::map {
namespace {

// The border of the lands with one set of guidelines. x is the longitude, y the latitude.
struct RegionBorder {
  RoadGuidelines guidelines;
  Ring ring;
};

const std::vector<RegionBorder>& region_borders() {
  static const std::vector<RegionBorder> all = {
#define ROAD_REGION(guidelines, ...) {RoadGuidelines::guidelines, {__VA_ARGS__}},
#include "compiler/map/road_guidelines.inc"
#undef ROAD_REGION
  };
  return all;
}

}  // namespace

RoadGuidelines guidelines_at(LonLat place) {
  for (const RegionBorder& border : region_borders())
    if (winding_number(border.ring, {place.lon_deg, place.lat_deg}) != 0) return border.guidelines;
  return RoadGuidelines::kElsewhere;
}

}  // namespace citykiln::map
