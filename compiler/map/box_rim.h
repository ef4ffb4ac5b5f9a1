// The rim of a box as a line: places on it are metres counter-clockwise from its south-west corner.
#pragma once

#include <optional>
#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/geometry/polygon.h"

namespace citykiln::map {

/// Length of the rim.
double rim_length_m(const Box2& box);

/// Where on the rim a point lies, 0 ≤ s < rim_length_m. @param p  On the rim.
double rim_place_m(const Box2& box, Vec2 p);

/// The corners strictly between two places, walking counter-clockwise from `from_m`; equal places: none.
Polyline rim_corners_between(const Box2& box, double from_m, double to_m);

/// The point of the rim nearest to a point inside; of equals the one on the south, east, north, then west side.
Vec2 nearest_on_rim(const Box2& box, Vec2 p);

/// A line's pieces inside the box.
struct Clipped {
  Polyline axis;  ///< Snapped; at least two different points; starts and ends on the rim or at the line's own ends.
};

/// Cuts a line at the rim. Places where it crosses are snapped and moved onto the rim, so they lie within 2^-10 m of the line. What only touches the
/// box in a point is left out. O(n).
std::vector<Clipped> clipped_to(const Polyline& line, const Box2& box);

}  // namespace citykiln::map
