// Spikes: samples of a heightmap that stand far above or below all that their neighbours foretell.
#pragma once

#include "compiler/contract/report.h"
#include "compiler/source/raster.h"

namespace citykiln::source {

/// No sample's fate depends on another more columns or rows away.
inline constexpr int kSpikeInfluence = 10;

/// Takes spikes for voids, which fill_voids then fills from what surrounds them. Run it before fill_voids.
///
/// A spike is one sample, or some of two by two, of which each lies on the same side of every height that its
/// neighbours foretell: along the four lines through it, between the nearest samples outside the spike, and straight on
/// from two of them on either side (beyond a void of one sample too). The nearest foretold height must be farther than
/// 12 m plus half a sample's width a sample that the spike is wide (45 m for 1, 79 m for 2 in SRTM at 67 m), and than
/// five times the median bend of the land around.
///
/// Guarantees: a sample stays where any line of neighbours leads up or down to it, as at summits, ridges, cliffs,
/// shores and towers more than two samples wide; nothing is changed but to NaN; a window gives what the whole raster
/// gives but within kSpikeInfluence of its edge; a second run finds nothing
/// but what three spikes in a row hid from each other. Diagnosed kHeightSpike, once a sample, with metres from the
/// nearest foretold height. Total: where fewer than five of the eight neighbours are known, nothing can be said, and
/// the sample stays. Cost: O(samples); 0.3 s a million.
Raster spikes_to_voids(Raster raster, Report& report);

}  // namespace citykiln::source
