// Moves places by metres, and measures short distances.
#pragma once

#include "compiler/edits/edit.h"

namespace citykiln::edits {

/// Returns a place that is moved east and north by metres on the ellipsoid, to 1e-7 degrees. Places of one element keep
/// their distances: less than 100 m apart, all are moved by the same number of 1e-7 degrees, or one more or less.
/// Accurate to 0.5 % up to 10 km; none is moved beyond the poles.
source::Location moved(source::Location at, Vec2 by_m);

/// Returns the places at most `radius_m` from a place. > 0.
Circle circle_about(source::Location centre, double radius_m);

/// True if a place is in a circle. Distances are accurate to 0.5 % up to 10 km.
bool is_in(const Circle& circle, source::Location at);

}  // namespace citykiln::edits
