// A place on Earth.
#pragma once

namespace citykiln {

/// A place in degrees on WGS84. In a map across 180° longitudes go on to 200° (source/across_180.h).
struct LonLat {
  double lon_deg = 0, lat_deg = 0;
  bool operator==(const LonLat&) const = default;
};

}  // namespace citykiln
