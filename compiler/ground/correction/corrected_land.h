// Corrects the samples of a heightmap by heights that are better known: a road in mountains lies on
// the land, so where a heightmap with samples 90 m apart is 20 m above the road, the heightmap is
// wrong.
//
//       .  heightmap                 Samples beside a line move until the land between them meets
//     .   .                          the line, within the error of the heightmap. Other samples
//    . ─ ─ .─ ─ ─ corrected land     stay, so the land returns to the heightmap within one step of
//   .───────────── road              samples.
#pragma once

#include <span>

#include "compiler/ground/correction/known_line.h"
#include "compiler/map/plane/heightfield.h"

namespace citykiln::ground {

/// The longest step of samples, in metres, that is not corrected: such heightmaps show roads
/// themselves.
inline constexpr double kFineSamples_m = 8;

/// The number of passes. Each one moves the samples about lines by the weighted mean of the changes
/// that are missing there.
inline constexpr int kCorrectionPasses = 6;

/// The distance of lines and samples that can move a sample, in steps of samples.
inline constexpr int kCorrectionSteps = kCorrectionPasses + 3;

/// Returns the field with samples moved towards lines, rounded to map::kHeightQuantum_m.
///
/// Method: simultaneous iterative reconstruction (Gilbert 1972) of the missing heights on bilinear
/// patches between samples, in kCorrectionPasses passes. Each line has about four places in a step.
/// The change at a road is limited to heightmap_error_m() of the given field; that at a level line
/// is not. Lines of water undo changes of others: land lower than the water, or more than 3 m above
/// it.
///
/// Guarantees: samples of cells without a line keep their heights. The field is returned as it is
/// if there are no lines, or if the step of samples is at most kFineSamples_m, for lines of any
/// kind. Places outside the field are skipped. A sample depends only on lines and samples within
/// kCorrectionSteps steps, so windows of a field agree farther inside, if their lines have the same
/// order. O(length of lines / step · log).
///
/// @param heights  A field, divided or not (map/plane/smooth_land.h); the result has as many parts.
map::Heightfield corrected_land(const map::Heightfield& heights, std::span<const KnownLine> lines);

}  // namespace citykiln::ground
