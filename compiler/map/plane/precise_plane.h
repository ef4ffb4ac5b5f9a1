// The plane's projection in x87 long double, with the same results on every x86-64 CPU. Used for values so near to a
// rounding tie that the last bit of a double would decide. Ten times slower than Plane.
#pragma once

#include "compiler/map/plane/plane.h"

namespace citykiln::map {

/// A place on the ellipsoid, degrees on WGS84.
struct PreciseLonLat {
  long double lon_deg = 0, lat_deg = 0;
};
/// A point of the plane, metres east and north of its origin.
struct PrecisePoint {
  long double x = 0, y = 0;
};

/// Returns the point of the plane with this origin at which a place lies. Method: Karney 2011, Krüger's series to sixth
/// order.
PrecisePoint precise_forward(LonLat origin, PreciseLonLat place);
/// Returns the place at a point p of the plane (metres), by correction steps: forward(result) is within 1e-12 m of p.
///
/// @param near  A place within a metre of the result, such as Plane::backward(p).
PreciseLonLat precise_backward(LonLat origin, Vec2 p, LonLat near);

}  // namespace citykiln::map
