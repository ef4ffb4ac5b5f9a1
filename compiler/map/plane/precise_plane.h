// The plane's projection in x87 long double, with the same results on every x86-64 CPU. Used for values so near to a
// rounding tie that the last bit of a double would decide. Ten times slower than Plane.
#pragma once

#include "compiler/map/plane/plane.h"

namespace citykiln::map {

struct PreciseLonLat {
  long double lon_deg = 0, lat_deg = 0;
};
struct PrecisePoint {
  long double x = 0, y = 0;
};

/// Returns the position of a place relative to the origin. Method: Karney 2011, Krüger's series to sixth order.
PrecisePoint precise_forward(LonLat origin, PreciseLonLat place);
/// Returns the place at p, by correction steps: forward(result) is within 1e-12 m of p.
///
/// @param near  A place within a metre, such as Plane::backward(p).
PreciseLonLat precise_backward(LonLat origin, Vec2 p, LonLat near);

}  // namespace citykiln::map
