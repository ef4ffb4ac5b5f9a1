#include "compiler/map/countries/driving_side.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace citykiln::map {
namespace {

// Hundredths of a degree.
struct Corner {
  std::int16_t lon = 0, lat = 0;
  constexpr bool operator==(const Corner&) const = default;
};

constexpr Corner kEnd{32767, 32767};
constexpr Corner kCorners[] = {
#define LEFT_DRIVING(...) __VA_ARGS__, kEnd,
#include "compiler/map/countries/driving_side.inc"
#undef LEFT_DRIVING
};
constexpr std::size_t kRingCount = static_cast<std::size_t>(std::count(std::begin(kCorners), std::end(kCorners), kEnd));

// A ring: the corners [first, last) of kCorners, and their box.
struct CornerRing {
  std::size_t first = 0, last = 0;
  Corner low{32767, 32767}, high{-32767, -32767};
};

constexpr std::array<CornerRing, kRingCount> corner_rings() {
  std::array<CornerRing, kRingCount> all{};
  std::size_t i = 0;
  for (CornerRing& border : all) {
    border.first = i;
    for (; kCorners[i] != kEnd; ++i) {
      const Corner c = kCorners[i];
      border.low = {std::min(border.low.lon, c.lon), std::min(border.low.lat, c.lat)};
      border.high = {std::max(border.high.lon, c.lon), std::max(border.high.lat, c.lat)};
    }
    border.last = i++;
  }
  return all;
}
constexpr std::array<CornerRing, kRingCount> kBorders = corner_rings();

bool is_in_box(const CornerRing& border, double lon, double lat) {
  return lon >= border.low.lon && lon <= border.high.lon && lat >= border.low.lat && lat <= border.high.lat;
}

// True where a ray to the east crosses the side from a to b.
bool is_west_of(Corner a, Corner b, double lon, double lat) {
  if ((a.lat > lat) == (b.lat > lat)) return false;
  return lon < a.lon + (lat - a.lat) * (b.lon - a.lon) / (b.lat - a.lat);
}

bool is_within(const CornerRing& border, double lon, double lat) {
  bool is_inside = false;
  Corner before = kCorners[border.last - 1];
  for (std::size_t i = border.first; i < border.last; before = kCorners[i++])
    is_inside ^= is_west_of(before, kCorners[i], lon, lat);
  return is_inside;
}

}  // namespace

DrivingSide driving_side_at(LonLat place) {
  // rings cover -180 to 180; the antimeridian is their western border
  const double lon = (place.lon_deg < 180 ? place.lon_deg : place.lon_deg - 360) * 100, lat = place.lat_deg * 100;
  // a ring within a ring is an island that drives on the right
  bool is_left = false;
  for (const CornerRing& border : kBorders)
    if (is_in_box(border, lon, lat)) is_left ^= is_within(border, lon, lat);
  return is_left ? DrivingSide::kLeft : DrivingSide::kRight;
}

}  // namespace citykiln::map
