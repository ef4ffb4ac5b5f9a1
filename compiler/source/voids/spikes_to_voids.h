// Removes spikes: heightmap samples far above or below every height that their neighbours predict.
#pragma once

#include "compiler/contract/findings/report.h"
#include "compiler/source/raster.h"

namespace citykiln::source {

/// The number of columns or rows within which other samples can change the result for a sample.
inline constexpr int kSpikeInfluence = 10;

/// Replaces spikes by voids. Call it before fill_voids(), which fills them.
///
/// A spike is one sample, or some samples of a two by two block, that all lie above, or all below, every height that
/// their neighbours predict. Predictions are made on the four lines through a sample: interpolated between the nearest
/// samples outside the spike, and extrapolated from the two samples on each side (across at most one void). The
/// distance to the nearest predicted height must be more than 12 m plus half of Raster::file_spacing_m, times the
/// spike's width in samples (with SRTM at 67 m, 45 m for 1 sample and 79 m for 2). It must also be more than five times
/// the median bend of the surrounding land; a sample's bend is its distance from the mean of its two neighbours.
///
/// Guarantees: a sample stays if any line of neighbours leads up or down to it, as at summits, ridges, cliffs, shores,
/// and towers more than two samples wide. A sample with fewer than five known neighbours of eight stays. Samples change
/// to NaN only. A window of a file gives the same result as the whole file, except within kSpikeInfluence of its edge.
/// A second call finds only spikes that were hidden by others (chains of three or more). Each sample is diagnosed
/// kHeightSpike with its distance to the nearest predicted height. Cannot fail. Cost: O(samples); 0.3 s for a million.
Raster spikes_to_voids(Raster raster, Report& report);

}  // namespace citykiln::source
