// Assumes pavements on a short bridge if the streets at both of its ends have pavements.
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/map/features.h"

namespace citykiln::assume {

/// A bridge way that is longer than this does not change.
inline constexpr double kLongestBridge_m = 128;

/// Returns the tracks, in the same order, with assumed pavements on bridges of streets. A side of a bridge gets a
/// pavement if no tag says whether it has one (Track::tagged_pavements), and the streets that continue from both ends
/// have one, tagged or assumed, on that side. It is as wide as the narrower one of these two.
///
/// Exactly one street on the ground has to end at each end of the bridge, so a bridge of several ways in a row does not
/// change. Runs after assume_pavements(). Depends on the streets at the ends, at most kLongestBridge_m away, and on
/// their assumed pavements. O(n log n), n: tracks.
std::vector<map::Track> assume_bridge_pavements(std::span<const map::Track> without, Report& report);

}  // namespace citykiln::assume
