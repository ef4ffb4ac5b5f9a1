// Directions by fractions of a turn, without libm, whose sine and cosine differ between CPUs in the last bit.
#pragma once

#include <numbers>

#include "compiler/geometry/vec.h"

namespace citykiln {

/// Half a turn in radians.
inline constexpr double kPi = std::numbers::pi;

/// Returns the unit vector {cosine, sine} of an angle given in full turns, counter-clockwise from +x.
///
/// Each component is within 5e-16 of the true one, and the length within 5e-16 of 1. Uses + − × and floor only, so that
/// every CPU gives the same bits. Quarter turns are exact. Any finite `turns` is allowed; beyond 2^40 the fraction of
/// `turns` has too few digits. O(1).
Vec2 direction_of(double turns);

}  // namespace citykiln
