// Removes blocks of broken samples from heightmaps: small groups of samples that stand far above or below the land on
// all sides.
#pragma once

#include "compiler/contract/findings/report.h"
#include "compiler/source/raster.h"

namespace citykiln::source {

/// The largest width and depth of a block, in samples.
inline constexpr int kLargestBlock = 6;
/// Samples more than this many columns or rows away do not change the result for a sample.
inline constexpr int kBlockInfluence = kLargestBlock - 1 + 3;

/// Replaces blocks of broken samples by voids. Call it after spikes_to_voids() and before fill_voids().
///
/// A step is a difference between neighbours of more than 12 m plus twice the sample spacing, Raster::file_spacing_m
/// (32 m at 10 m, 72 m at 30 m). A block is a group of neighbouring samples that
/// - is at most six columns wide and six rows deep, and does not touch the raster's edge;
/// - is a step higher than each sample around it, diagonal ones included, or a step lower than each; up to a quarter of
///   its edges may border on voids;
/// - is even: its distances from a plane fitted to the land around it, two samples wide, are all more than a step, and
///   the largest is at most one and a half times the smallest;
/// - stands in calm land: no sample of that land is farther from the plane than a quarter of the smallest distance.
///
/// A block of zeros needs no step: samples within 1 mm of 0 in calm land that lies more than 6 m plus half the sample
/// spacing above or below 0 are what programs write where they know no height. They may be mixed into the samples
/// beside them, which belong to the block if they are farther from the plane than the land is.
///
/// Guarantees: cliffs, ridges, gorges, walls, wide towers and quarries with a ramp stay, since samples lead out of them
/// without a step. A rock tower stays if the samples at its foot are between its height and that of the land, or if its
/// summit is uneven; one with a level summit and sheer walls between two samples on all sides is removed like an error.
/// Samples change to NaN only. A window of a file gives the same result as the whole file, except within
/// kBlockInfluence of its edge. Each block is diagnosed once as kHeightSpike, with its largest distance from the plane.
/// Cannot fail. Cost: O(samples).
Raster blocks_to_voids(Raster raster, Report& report);

}  // namespace citykiln::source
