// Vertical clearance where a line passes over another line or over water without a junction, against the wanted
// clearance (ground/profiles/crossings.h). Uses recipes only, independently of the crossings that the planner found.
//
//     ====X====  a deck passes over ground roads, paths and water, over tunnels, and over decks with a lower layer tag
//     ----X----  ground roads and paths pass over tunnels
//     ....X....  a tunnel passes over tunnels with a lower layer tag
#pragma once

#include <cstdint>

#include "compiler/scene/scene.h"

namespace citykiln::verify {

struct Clearances {
  std::uint64_t crossings = 0;   ///< Pairs of lines, or of a line and a water.
  std::uint64_t shortfalls = 0;  ///< Crossings that miss the wanted clearance by more than ground::kShortfallMargin_m.
  std::uint64_t shortfalls_over_1_m = 0, shortfalls_over_3_m = 0;
  double largest_shortfall_m = 0;
  OsmId upper, lower;  ///< The pair with the largest shortfall.
  Vec2 at;
};

/// Measures all crossings of the scene. Two lines cross where their axes intersect, or where one runs within the
/// other's width (tested every 4 m), unless they are connected close by or one descends beside the other
/// (ground/profiles/crossings.h). Lines without a profile lie on the graded terrain. Each crossing counts once, in the
/// tile that contains it. O(n log n).
Clearances measure_clearances(const scene::Scene& scene, int threads);

}  // namespace citykiln::verify
