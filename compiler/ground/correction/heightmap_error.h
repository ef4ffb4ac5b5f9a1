// The vertical error of a heightmap: how far the real land may be from the surface through its
// samples.
#pragma once

#include "compiler/map/plane/heightfield.h"

namespace citykiln::ground {

/// Returns the error of the surface through a heightmap's samples at a place, in metres: the sum of
/// - bend: half of the largest second difference, east or north, at the four samples about the
///   place. The land may bend as much between samples.
/// - shift: a quarter of the difference between the highest and the lowest of the four samples.
///   Samples, and the map, lie up to a quarter of a step beside their true places.
/// - noise and rounding: 1/32 of the longer step of samples, at most 1 m.
///
/// The error was measured on five tiles of SRTM of one degree each (Andorra, Engadin,
/// Liechtenstein, Monaco, Berlin), with only every second, third or fourth sample kept. At least
/// 98.5 % of the others lie within the error, and 97.8 to 99.9 % within bend and noise alone; this
/// test does not move samples, so it cannot measure shift.
///
/// The result depends on 4 x 4 samples; those at the border of the field stand for the ones beyond
/// it. O(1).
/// @param p  Plane metres; moved to the border if it is outside.
double heightmap_error_m(const map::Heightfield& heights, Vec2 p);

}  // namespace citykiln::ground
