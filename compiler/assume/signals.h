// Assumes traffic signals where two main roads cross, if the map shows no signals near.
//
//           |   |           A node has signals if
//     ------+   +------     - three arms of primary or secondary roads leave it, two of them nearly straight on and one
//     ----------------        across;
//     ------+   +------     - at least kLeastHouses buildings stand within kHousesWithin_m;
//           |   |           - no signals are mapped within kNoneMapped_m.
//
// The rule was measured with mapped signals left out, and so without kNoneMapped_m. Nodes that it finds have mapped
// signals: Boston 55 of 59, Chicago 115 of 115, Berlin 9 of 10, Nice 3 of 4, but Malta 1 of 37 and Andorra 0 of 9. The
// other constants were fitted to these places. 19 to 66 % of all junctions of streets have signals in the first four.
#pragma once

#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/map/features.h"

namespace citykiln::assume {

/// Signals are assumed only this far from all that are mapped, in metres.
inline constexpr double kNoneMapped_m = 1000;
/// The least number of buildings about a junction with signals, and how far from it they count, in metres.
inline constexpr int kLeastHouses = 3;
inline constexpr double kHousesWithin_m = 80;

/// The tracks and things of a map with assumed signals.
struct WithSignals {
  std::vector<map::Track> tracks;         ///< With points of TrackPointKind::kSignals.
  std::vector<map::ThingFeature> things;  ///< With things of kind "traffic_signals", sorted by id.
};

/// Returns the tracks and the things with assumed signals. Their radius is kNoneMapped_m. O(n log n).
WithSignals assume_signals(const map::FeatureView& features, Report& report);

}  // namespace citykiln::assume
