// The centroid of a polygon.
#pragma once

#include "compiler/geometry/polygon.h"

namespace citykiln {

/// Returns the centre of mass of a polygon of uniform density; for polygons without area the first point. May lie
/// outside of a concave polygon. O(n).
/// @param polygon  With at least one point.
Vec2 centroid(const Polygon& polygon);

}  // namespace citykiln
