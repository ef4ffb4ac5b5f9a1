// Removes values that stand for no height from heightmaps that do not declare them: -9999, 99999, or 0 in land that is
// far from it.
#pragma once

#include <optional>

#include "compiler/contract/report.h"
#include "compiler/contract/result.h"
#include "compiler/source/raster.h"

namespace citykiln::source {

/// Heights on Earth, from the deepest shore with room below it to the highest summit with room above it.
inline constexpr double kLowestOnEarth_m = -500, kHighestOnEarth_m = 9000;

/// Replaces patches of samples that hold no heights by voids. Call it before spikes_to_voids() and fill_voids().
///
/// A patch is a group of neighbouring samples that
/// - are not on Earth, half of them or more of one value, beside samples that are on Earth; or of a value such as
///   -9999, -32767, 65535 or 99999 (all nines, or an end of a number type), wherever they are; or
/// - have one value that may be a height, but also stands for none: 0, a negative value, one from 6000 m on, or
///   one of Raster::code_heights_m. It is at most half of the raster; it is wider or deeper than a block of
///   blocks_to_voids(), or touches the edge of the raster; the land on all sides lies above it, or on all sides below
///   it, by more than 12 m plus half of the sample spacing (60 m plus twice the spacing at the raster's edge); and this
///   is four times the steps of that land.
///
/// The samples around a patch into which a program has mixed its value are replaced too. The sea, lakes and polders
/// stay, since shores lead down to them, and so do single samples, which are spikes. Samples change to NaN only.
/// Diagnosed: kHeightCode, once for each value, with the number of its samples. Cannot fail. O(samples).
Raster codes_to_voids(Raster raster, Report& report);

/// Returns an error for the first height that is not on Earth, with its place; nothing if all heights are. Voids are
/// ignored. O(samples).
std::optional<Error> height_not_on_earth(const Raster& raster);

}  // namespace citykiln::source
