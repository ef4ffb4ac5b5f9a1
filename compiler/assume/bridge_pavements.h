// Assumes pavements on short bridges between streets that have them.
#pragma once

#include <vector>

#include "compiler/contract/report.h"
#include "compiler/map/features.h"

namespace citykiln::assume {

/// Longer bridges stay as mapped.
inline constexpr double kLongestBridge_m = 128;

/// Returns the tracks; a bridge of a street has a pavement on each silent side (Track::tagged_pavements) on which both
/// streets that go on from its ends have one: as wide as the narrower one. At each end exactly one street on the ground
/// ends. O(n log n).
std::vector<map::Track> assume_bridge_pavements(std::vector<map::Track> tracks, Report& report);

}  // namespace citykiln::assume
