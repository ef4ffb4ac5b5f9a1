// Smooth land: a heightfield with vertices between its samples, on the smooth surface through these
// (bicubic.h).
#pragma once

#include "compiler/map/plane/heightfield.h"

namespace citykiln::map {

/// Returns into how many parts smooth_land() divides each step of samples: 1, 2 or 4, the fewest
/// with which the longer step of vertices is at most 24 m, else 4.
/// @param step_m  The step of samples east and north.
int smooth_parts(Vec2 step_m);

/// Returns a field without the outermost ring of samples, with `parts` vertices for each step of
/// samples. Samples keep their heights; other vertices lie on the surface, rounded to
/// kHeightQuantum_m. Planes stay planes within half a quantum, and level pieces stay level. A
/// height depends only on the 4 x 4 samples about it, so fields that share samples are equal where
/// they overlap, with the same bits on every CPU. O(vertices).
///
/// @param samples  An undivided field (parts = 1). It has at least 4 columns and rows if it is
///                 divided.
/// @param parts    1, 2 or 4. The field is returned as it is, with its outermost ring, for 1.
Heightfield smooth_land(Heightfield samples, int parts);

/// Returns the field of samples from which smooth_land() made a field, with the outermost ring; an
/// undivided field as it is. O(samples).
Heightfield samples_of(const Heightfield& field);

}  // namespace citykiln::map
