// The plane's projection in x87 long double, whose results are the same on every x86-64 CPU: for what lies so near to a
// tie of rounding that the last bit of a double would decide. Ten times slower than Plane.
#pragma once

#include "compiler/map/plane.h"

namespace citykiln::map {

struct PreciseLonLat {
  long double lon_deg = 0, lat_deg = 0;
};
struct PrecisePoint {
  long double x = 0, y = 0;
};

/// Karney 2011, Krüger's series to sixth order; from the origin.
PrecisePoint precise_forward(LonLat origin, PreciseLonLat place);
/// The inverse by correction: forward(result) is within 1e-12 m of p. @param near  A place within a metre, e.g.
/// Plane::backward.
PreciseLonLat precise_backward(LonLat origin, Vec2 p, LonLat near);

}  // namespace citykiln::map
