// Where one line of a scene passes over another, or over water, without meeting it: how much room is there, against
// what is wanted (ground/crossings.h). From the recipes alone, apart from what the planner took for a crossing.
//
//     ====X====  a deck passes over roads, paths and water of the ground, over bores, and over decks of lower layer=*
//     ----X----  the ground's roads and paths over bores
//     ....X....  a bore over bores of lower layer=*
#pragma once

#include <cstdint>

#include "compiler/scene/scene.h"

namespace citykiln::verify {

struct Clearances {
  std::uint64_t crossings = 0;   ///< Pairs of lines, or of a line and a water.
  std::uint64_t shortfalls = 0;  ///< Of these, by more than ground::kShortfallMargin_m.
  std::uint64_t shortfalls_over_1_m = 0, shortfalls_over_3_m = 0;
  double largest_shortfall_m = 0;
  OsmId upper, lower;  ///< Which lacks most.
  Vec2 at;
};

/// A pair crosses where its axes do, or where one runs along within the other's width, looked at every 4 m. Not where
/// they are joined close by, or one comes down beside the other (ground/crossings.h). What has no profile lies on the
/// graded terrain. A crossing is its chunk's in whose tile it lies, so each counts once. O(n log n).
Clearances measure_clearances(const scene::Scene& scene, int threads);

}  // namespace citykiln::verify
