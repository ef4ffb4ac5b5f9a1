// Where an invented world lies on the Earth: the plane of invented_map.h as longitudes and latitudes.
#pragma once

#include <array>
#include <cstdint>

#include "compiler/geometry/lonlat.h"
#include "compiler/geometry/vec.h"

namespace citykiln::invent {

/// A place in whole 1e-7 degrees, as maps have it: about 11 mm.
struct MapPlace {
  std::int32_t lon = 0, lat = 0;
  auto operator<=>(const MapPlace&) const = default;
};

/// The transverse Mercator projection of WGS84 about a place, with scale 1 there. Method: Krüger's series to the fourth
/// order of the flattening; error below 1 µm within 300 km. Every CPU gives the same bits. Source: Karney, "Transverse
/// Mercator with an accuracy of a few nanometers", J. Geodesy 85, 2011.
class WorldPlace {
 public:
  /// @param middle  The middle of the world; latitudes from -80 to 80.
  explicit WorldPlace(LonLat middle);
  LonLat middle() const { return middle_; }
  /// Returns the place of a point of the plane.
  LonLat degrees_of(Vec2 p) const;
  MapPlace map_place_of(Vec2 p) const;
  /// Returns the south-west and north-east corners of the largest box in degrees inside a square about the middle.
  std::array<MapPlace, 2> box_inside(double side_m) const;

 private:
  LonLat middle_;
  double northing_ = 0;  // of the middle, in rectifying radii
};

}  // namespace citykiln::invent
