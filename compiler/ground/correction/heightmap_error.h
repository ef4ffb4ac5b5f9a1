// The error of a heightmap: how far the land may be from the surface through its samples.
#pragma once

#include "compiler/map/plane/heightfield.h"

namespace citykiln::ground {

/// Returns the error of the surface through the samples of a heightmap at a place, in metres: the sum of
/// - half of the largest second difference, east and north, at the four samples about the place: the bend of the land
///   between samples;
/// - a quarter of the difference between the highest and the lowest of the four: the samples, and the places of the
///   map, lie up to a quarter of a step beside their places;
/// - 1/32 of the samples' distance, at most 1 m: rounding and noise.
///
/// Measured on SRTM of five degrees (Andorra, Engadin, Liechtenstein, Monaco, Berlin): when every second, third or
/// fourth sample is kept, at least 98.5 % of those left out lie within the error, and 97.8 to 99.9 % within its first
/// and last summand. The second summand is for places, which leaving out samples does not move. Depends on 4 x 4
/// samples. O(1).
double heightmap_error_m(const map::Heightfield& heights, Vec2 p);

}  // namespace citykiln::ground
