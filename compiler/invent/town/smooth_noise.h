// Smooth noise on the plane.
#pragma once

#include <cstdint>

#include "compiler/geometry/vec.h"

namespace citykiln::invent {

/// Returns a number in -1 … 1 that changes over about wave_m. Values on a lattice of wave_m are random and are blended
/// by cubic weights. O(1).
double smooth_noise(std::uint64_t seed, Vec2 p, double wave_m);

}  // namespace citykiln::invent
