// Removes spikes: heightmap samples far above or below every height that their neighbours predict.
#pragma once

#include "compiler/contract/report.h"
#include "compiler/source/raster.h"

namespace citykiln::source {

/// The result for a sample depends on samples up to this many columns or rows away.
inline constexpr int kSpikeInfluence = 10;

/// Replaces spikes by voids, which fill_voids() then fills. Must run before it.
///
/// A spike is a sample, or a subset of a block of two by two, whose heights all lie on the same side of every height
/// predicted by their neighbours. Predictions are made on the four lines through a sample: interpolated between the
/// nearest samples outside the spike, and extrapolated from two samples on either side (across at most one void). The
/// nearest predicted height must be farther than 12 m plus half a sample's spacing for each sample of the spike's width
/// (45 m for 1 sample, 79 m for 2 in SRTM at 67 m), and farther than five times the median bend of the surrounding
/// land.
///
/// Guarantees: a sample stays if any line of neighbours leads up or down to it, as at summits, ridges, cliffs, shores
/// and towers more than two samples wide; samples change to NaN only; a window gives the same result as the whole
/// raster, except within kSpikeInfluence of its edge; a second run finds only what three spikes in a row hid from each
/// other. Each sample is diagnosed kHeightSpike with its distance to the nearest predicted height. A sample with fewer
/// than five known neighbours of eight stays. Cannot fail. Cost: O(samples); 0.3 s for a million.
Raster spikes_to_voids(Raster raster, Report& report);

}  // namespace citykiln::source
