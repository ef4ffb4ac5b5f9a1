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

/// Returns the heightmap with voids (NaN) in place of patches of samples that hold no heights. No sample changes
/// otherwise. Call it before spikes_to_voids() and fill_voids().
///
/// A patch is a group of samples that touch by sides or corners. A height is on Earth from kLowestLand_m to
/// kHighestLand_m. A patch is replaced if it is of one of three sorts:
/// 1. It is not on Earth, and at least half of its samples have one usual code: nines only (9999 to 9999999), 10000,
///    32767, 32768 or 65535, of either sign.
/// 2. It is not on Earth, has two samples or more, at least half of them have one value, and it lies beside a sample
///    that is on Earth.
/// 3. All its samples have one value on Earth that is 0 or below, 6000 m or more, or in Raster::code_heights_m, and:
///    - it has at most half of the raster's samples;
///    - it is larger than blocks_to_voids() takes, or it has at least three samples and touches the raster's edge;
///    - the land three samples away lies above it, or all of it lies below it. 98 % of this land is at least 12 m plus
///      half of the sample spacing away from the patch's value (60 m plus twice the spacing if the patch touches the
///      raster's edge), and at least four times as far as the land's own steps (their 90th percentile);
///    - of the samples two away, 95 % lie on the same side, at more than half of the distance that 98 % of the land
///      three samples away reaches.
///
/// Samples up to two away from a patch are replaced too if a program has mixed the patch's value into them: those that
/// differ from the land beside them by more than the land's steps explain. The sea, lakes and polders stay, since
/// shores lead down to them, and so do single samples, which are spikes. The surroundings of a patch decide, so a
/// smaller window of a file may have another result at its edge.
///
/// Diagnosed: kHeightCode, once for each value, with the number of samples replaced on its account. Cannot fail.
/// O(n log n) in samples.
/// @param raster  With all samples (Raster::has_all_samples()).
Raster codes_to_voids(Raster raster, Report& report);

/// Returns an error for the first height that is not on Earth, with its place; nothing if all heights are. Voids are
/// ignored. O(samples).
std::optional<Error> first_height_off_land(const Raster& raster);

}  // namespace citykiln::source
