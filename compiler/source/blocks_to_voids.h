// Removes blocks of broken samples: small groups of heightmap samples that stand far above or below the land on all
// sides.
#pragma once

#include "compiler/contract/report.h"
#include "compiler/source/raster.h"

namespace citykiln::source {

/// The largest width and depth of a block in samples.
inline constexpr int kLargestBlock = 6;
/// The number of columns or rows within which other samples can change the result for a sample.
inline constexpr int kBlockInfluence = kLargestBlock - 1 + 2;

/// Replaces blocks of broken samples by voids. Call it after spikes_to_voids() and before fill_voids().
///
/// A block is a group of samples that
/// - is at most six columns wide and six rows deep, and does not touch the raster's edge;
/// - is higher than each sample around it, diagonal ones included, or lower than each, by more than 12 m plus twice the
///   sample spacing (32 m at 10 m, 72 m at 30 m), so no sample leads up or down to it;
/// - lies as far above or below the plane through the land around it, two samples wide, everywhere: its largest
///   distance from that plane is at most one and a half times its smallest;
/// - stands in calm land: no sample around it is farther from that plane than a quarter of the block's distance.
///
/// Guarantees: cliffs, ridges, gorges, walls, wide towers and quarries with a ramp stay, since samples lead out of
/// them. A tower of rock stays if the samples at its foot are between its height and that of the land, or if its
/// summit is uneven. A tower with a level summit and sheer walls between two samples on all sides is not told from an
/// error. Samples change to NaN only. A window gives the same result as the whole raster, except within
/// kBlockInfluence of its edge. Each block is diagnosed kHeightSpike once, with its distance from the plane. Cannot
/// fail. Cost: O(samples).
Raster blocks_to_voids(Raster raster, Report& report);

}  // namespace citykiln::source
