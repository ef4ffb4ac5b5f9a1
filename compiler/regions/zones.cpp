#include "compiler/regions/zones.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/geometry/mathematics.h"

namespace citykiln::regions {
namespace {

// The mean radius of the Earth, and the length of a degree of latitude at the poles, the longest.
constexpr double kRadius_m = 6371000, kDegree_m = 111694;
// OSM's grid of coordinates.
constexpr double kStepsOfDegree = 1e7;

// Where a box is widest.
double widest_m(const source::LonLatBox& box) {
  const bool holds_equator = box.south < 0 && box.north > 0;
  const double nearest_deg = holds_equator ? 0 : std::min(std::abs(box.south), std::abs(box.north));
  return (box.east - box.west) * kDegree_m * sine(90 - nearest_deg);
}

double cut(double low, double high, int i, int count) {
  if (i == 0) return low;
  if (i == count) return high;
  return std::floor((low + (high - low) * i / count) * kStepsOfDegree + 0.5) / kStepsOfDegree;
}

int pieces(double length_m, double most_m) { return std::max(1, static_cast<int>(std::ceil(length_m / most_m))); }

}  // namespace

std::string to_string(const Zone& zone) { return fmt::format("{}_{}", zone.x, zone.y); }

std::vector<Zone> zones_of(const source::LonLatBox& extent, double side_m) {
  const int columns = pieces(widest_m(extent), side_m),
            rows = pieces((extent.north - extent.south) * kDegree_m, side_m);
  std::vector<Zone> zones;
  for (int x = 0; x < columns; ++x)
    for (int y = 0; y < rows; ++y)
      zones.push_back({x,
                       y,
                       {cut(extent.west, extent.east, x, columns), cut(extent.south, extent.north, y, rows),
                        cut(extent.west, extent.east, x + 1, columns), cut(extent.south, extent.north, y + 1, rows)}});
  return zones;
}

double scale_error(const Zone& zone) {
  const double half_m = widest_m(zone.box) / 2;
  return half_m * half_m / (2 * kRadius_m * kRadius_m);
}

}  // namespace citykiln::regions
