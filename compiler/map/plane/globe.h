// Maps the map plane, a transverse Mercator projection (plane.h), to the WGS84 ellipsoid. Results are in one local
// frame of a run: x east, y north, z up, metres, with its origin on the ellipsoid at the plane's origin. One transform
// places that frame on the globe.
#pragma once

#include <array>

#include "compiler/geometry/vec.h"
#include "compiler/map/plane/bent_point.h"
#include "compiler/map/plane/plane.h"

namespace citykiln::map {

/// Maps points of the plane to the ellipsoid. Method: Krüger's series to sixth order (Karney 2011), inverse; latitudes
/// by the series from the conformal latitude; then closed forms. Uses + - * / and the square root with direction_of()
/// (geometry/trig.h), so that every CPU gives the same bits.
///
/// Error of a position: below 1e-6 m within 200 km of the origin and up to 84° of latitude; of an axis: below 2e-7.
/// Lengths on the globe are longer than in the plane by a share of at most |z| / kLeastRadius_m.
class Globe {
 public:
  explicit Globe(LonLat origin);

  /// @param p  Plane metres; z is the height above the ellipsoid. |x| up to 1500 km. About 0.3 µs.
  BentPoint at(Vec3 p) const;

  /// The frame of the run in earth-centred coordinates (ECEF, metres): a 4 x 4 matrix, column by column.
  std::array<double, 16> to_earth() const;

 private:
  Vec2 direction_of_latitude_, direction_of_longitude_;  ///< Cosine and sine of the origin's angles.
  Vec3 earth_;          ///< The origin relative to the Earth's centre, as if its longitude were 0.
  double along_m_ = 0;  ///< Distance in the plane from the equator to the origin along its meridian.
};

/// The smallest radius of curvature of the ellipsoid: along the meridian at the equator.
inline constexpr double kLeastRadius_m = 6335439.0;

/// Returns an upper bound of the sag of a line: the largest distance between a straight line of the plane after it is
/// mapped to the ellipsoid, and the straight line between its mapped ends. It is 1.2 · length² / (8 kLeastRadius_m).
/// The factor 1.2 covers sloped lines, along which the direction of the vertical changes.
/// @param length_m  Length in three dimensions; at most 100 km.
double sag_m(double length_m);

/// The length of a line for which sag_m() returns `sag_m`.
double length_with_sag_m(double sag_m);

}  // namespace citykiln::map
