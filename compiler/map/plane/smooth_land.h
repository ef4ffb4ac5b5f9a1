// Smooth land: a heightfield with vertices between the samples, on the smooth surface through them (bicubic.h).
#pragma once

#include "compiler/map/plane/heightfield.h"

namespace citykiln::map {

/// Returns the number of parts, 1, 2 or 4, into which smooth_land() divides each step of samples: the fewest for which
/// the longer step is at most 24 m.
int smooth_parts(Vec2 step_m);

/// Returns a field over all samples but the outermost ring, with `parts` steps from sample to sample. Heights at
/// samples are the samples'; others lie on the bicubic surface through them, rounded to kHeightQuantum_m. Planes stay
/// planes within half a quantum, level pieces stay level. A height depends on the 4 x 4 samples about it only, so
/// fields that share samples are equal where they overlap, to the last bit, on every CPU. O(vertices).
///
/// @param samples  Without samples of its own; at least 4 columns and rows if it is divided.
/// @param parts    1, 2 or 4. With 1 the field is returned as it is.
Heightfield smooth_land(Heightfield samples, int parts);

/// Returns the field of the samples from which smooth_land() made a field; the field itself if it was not divided.
Heightfield samples_of(const Heightfield& field);

}  // namespace citykiln::map
