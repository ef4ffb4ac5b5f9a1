// Measures the strip between the kerb of a street and a footway that is mapped beside it in built-up land.
//
//     houses    [###]   [###]   [###]
//     footway   - - - - - - - - - - -   a side has a strip if at least half of its samples see a footway whose nearer
//     strip     ......................  edge is within kBesideKerb_m of the kerb: grass up to the footway where
//     ==============================>   verges.inc has verges for class, country group and share of houses; else
//                                       pavement up to the footway's farther edge
#pragma once

#include <cstdint>

#include "compiler/assume/beside.h"
#include "compiler/map/features.h"

namespace citykiln::assume {

/// A strip beside the kerb, up to the footway. Both distances are from the kerb in metres: the 0.8 quantile over the
/// samples that see a footway; 0 if there is no strip.
struct FootwayStrip {
  bool may_be_verge = false;  ///< True if verges are usual in such a street.
  double near_m = 0;          ///< The nearer edge of the footway.
  double far_m = 0;           ///< Its farther edge.
};

struct BothFootwayStrips {
  FootwayStrip left, right;
};

/// Returns the strips of both sides of a stretch, by samples about every 8 m, whatever else lies there.
/// O(length · lines near it).
BothFootwayStrips footway_strips(const Surroundings& surroundings, const map::Track& stretch);

}  // namespace citykiln::assume
