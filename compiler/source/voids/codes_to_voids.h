// Removes values that stand for no height from heightmaps that do not declare them: -9999, 99999, or 0 in land that is
// far from it.
#pragma once

#include <optional>

#include "compiler/contract/findings/report.h"
#include "compiler/contract/result.h"
#include "compiler/source/raster.h"

namespace citykiln::source {

/// Heights on Earth, from the deepest shore with room below it to the highest summit with room above it.
inline constexpr double kLowestLand_m = -500, kHighestLand_m = 9000;

/// Replaces patches of samples that hold no heights by voids. Call it before spikes_to_voids() and fill_voids().
///
/// A patch is a group of neighbouring samples of one of three sorts:
/// 1. not on Earth, at least half of them of one usual code: nines only (9999 to 9999999, of either sign), 10000,
/// 32767,
///    32768, 65535;
/// 2. not on Earth, two or more, at least half of them of one value, beside a sample that is on Earth;
/// 3. on Earth, all of one value that is 0 or below, 6000 m or more, or in Raster::code_heights_m, where this is true:
///    - it has at most half of the raster's samples;
///    - it is larger than blocks_to_voids() takes, or has three samples and touches the raster's edge;
///    - the land three samples away lies above it on all sides, or below it (2 % of it need not), by at least 12 m and
///      half of the sample spacing (at the raster's edge 60 m and twice the spacing), and by four times the steps of
///      that land (their 90th percentile).
///
/// The samples around a patch into which a program has mixed its value are replaced too. The sea, lakes and polders
/// stay, since shores lead down to them, and so do single samples, which are spikes. Samples change to NaN only. The
/// surroundings of a patch decide, so a smaller window of a file may have another result at its edge.
/// Diagnosed: kHeightCode, once for each value, with the number of its samples. Cannot fail. O(n log n) in samples.
Raster codes_to_voids(Raster raster, Report& report);

/// Returns an error for the first height that is not on Earth, with its place; nothing if all heights are. Voids are
/// ignored. O(samples).
std::optional<Error> first_height_off_land(const Raster& raster);

}  // namespace citykiln::source
