// Corrects the samples of a heightmap by heights that are known better than it: a road in mountains lies on the land,
// so where a heightmap of 90 m has the land 20 m above the road, the heightmap is wrong.
//
//       .  heightmap                 The samples about a line move until the land between them meets the line, as far
//       as
//     .   .                          the heightmap's error allows. Other samples stay, so the land returns to the
//    . ─ ─ .─ ─ ─ corrected land     heightmap within one step of samples.
//   .───────────── road
#pragma once

#include <span>

#include "compiler/ground/correction/known_line.h"
#include "compiler/map/plane/heightfield.h"

namespace citykiln::ground {

/// Heightmaps with samples at most this far apart show roads themselves: their samples stay, apart from level areas.
inline constexpr double kFineSamples_m = 8;

/// The number of passes. Each moves samples within one step about lines, by the mean of what is missing there.
inline constexpr int kCorrectionPasses = 6;

/// The distance of data that can move a sample, in steps of samples.
inline constexpr int kCorrectionSteps = kCorrectionPasses + 3;

/// Returns the field with samples moved towards lines.
///
/// Method: simultaneous iterative reconstruction (Gilbert 1972) of the missing heights on bilinear patches between
/// samples, kCorrectionPasses times. Roads move the land by at most heightmap_error_m(), measured once, before. Lines
/// are sampled every quarter of a step.
///
/// Guarantees: samples farther than one step from all lines keep their heights; without lines the field is returned as
/// it is. A sample depends on lines and samples within kCorrectionSteps steps, in the order of the lines, so windows of
/// a field agree farther inside. O(length of lines / step · log).
///
/// @param heights  May be divided (map/plane/smooth_land.h); the result is divided into as many parts.
map::Heightfield corrected_land(const map::Heightfield& heights, std::span<const KnownLine> lines);

}  // namespace citykiln::ground
