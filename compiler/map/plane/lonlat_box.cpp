#include "compiler/map/plane/lonlat_box.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

namespace citykiln::map {

source::LonLatBox lonlat_box_of(const Box2& box, const Plane& plane) {
  assert(!box.is_empty());
  source::LonLatBox around{180, 90, -180, -90};
  for (const double x : {box.min.x, box.centre().x, box.max.x}) {
    for (const double y : {box.min.y, box.centre().y, box.max.y}) {
      const LonLat place = plane.backward({x, y});
      around = {std::min(around.west, place.lon_deg), std::min(around.south, place.lat_deg),
                std::max(around.east, place.lon_deg), std::max(around.north, place.lat_deg)};
    }
  }
  return around;
}

source::LonLatBox geojson_box_of(const Box2& box, const Plane& plane) {
  source::LonLatBox around = lonlat_box_of(box, plane);
  if (around.east - around.west <= 180) return around;
  around.west = 180, around.east = -180;
  for (const double x : {box.min.x, box.max.x})
    for (const double y : {box.min.y, box.centre().y, box.max.y}) {
      const double lon_deg = plane.backward({x, y}).lon_deg;
      if (lon_deg < 0) around.east = std::max(around.east, lon_deg);
      if (lon_deg >= 0) around.west = std::min(around.west, lon_deg);
    }
  return around;
}

std::string text_of(const source::LonLatBox& box) {
  return fmt::format("{:.4f},{:.4f},{:.4f},{:.4f}", box.west, box.south, box.east, box.north);
}

}  // namespace citykiln::map
