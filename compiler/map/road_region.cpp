#include "compiler/map/road_region.h"

#include <vector>

#include "compiler/geometry/polygon.h"

namespace citykiln::map {
namespace {

// A region's border. x is the longitude, y the latitude.
struct Border {
  RoadRegion region;
  Ring ring;
};

const std::vector<Border>& borders() {
  static const std::vector<Border> all = {
#define ROAD_REGION(region, ...) {RoadRegion::region, {__VA_ARGS__}},
#include "compiler/map/road_region.inc"
#undef ROAD_REGION
  };
  return all;
}

}  // namespace

RoadRegion road_region_at(LonLat place) {
  for (const Border& border : borders())
    if (winding_number(border.ring, {place.lon_deg, place.lat_deg}) != 0) return border.region;
  return RoadRegion::kElsewhere;
}

}  // namespace citykiln::map
