#include <algorithm>
#include <string>

#include "compiler/geometry/polygons/clip_polyline.h"
#include "compiler/invent/country/add_country.h"

namespace citykiln::invent {
namespace {

// water is mapped a little beyond the square, and ends in whole cells of what reads it
constexpr double kWaterBeyond_m = 320;
constexpr double kClipStep_m = 0x1p-7;
// narrower ones are streams
constexpr double kLeastRiver_m = 5;

std::string width_text(double width_m) {
  const int tenths = std::max(5, static_cast<int>(width_m * 10 + 0.5));
  return std::to_string(tenths / 10) + (tenths % 10 != 0 ? "." + std::to_string(tenths % 10) : "");
}

void add_river(const River& river, const Box2& box, InventedMap& map) {
  const double width_m = *std::ranges::max_element(river.width_m);
  for (Polyline& part : clipped_to(river.axis, box, kClipStep_m))
    map.lines.push_back(
        {std::move(part),
         {{"waterway", width_m >= kLeastRiver_m ? "river" : "stream"}, {"width", width_text(width_m)}}});
}

/// Adds the border of the sea, with land on its left.
void add_coast(const Ring& sea, const Box2& box, InventedMap& map) {
  Polyline coast(sea.rbegin(), sea.rend());
  coast.push_back(coast.front());
  for (Polyline& part : clipped_to(coast, box, kClipStep_m))
    map.lines.push_back({std::move(part), {{"natural", "coastline"}}});
}

}  // namespace

void add_water(const Terrain& terrain, double side_m, InventedMap& map) {
  const double half_m = std::min(side_m / 2 + kWaterBeyond_m, terrain.side_m / 2 - 1);
  const Box2 box{{-half_m, -half_m}, {half_m, half_m}};
  for (const River& river : terrain.rivers) add_river(river, box, map);
  for (const Polygon& lake : terrain.lakes) map.areas.push_back({lake, {{"natural", "water"}, {"water", "lake"}}});
  for (const Polygon& sea : terrain.sea)
    for (const Ring* ring : rings_of(sea)) add_coast(*ring, box, map);
}

}  // namespace citykiln::invent
