// Measures the vertical clearance where a line passes over another line or over water without a junction, and compares
// it with the wanted clearance (ground/profiles/crossings/crossings.h). Uses recipes only, independently of the
// crossings that the planner found.
//
//     ====X====  a deck passes over ground roads, paths and water, over tunnels, and over decks with a lower layer tag
//     ----X----  ground roads and paths pass over tunnels
//     ....X....  a tunnel passes over tunnels with a lower layer tag
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "compiler/outputs/findings.h"
#include "compiler/scene/scene.h"

namespace citykiln::verify {

/// A crossing whose clearance is smaller than wanted by more than ground::kShortfallMargin_m.
struct ClearanceShortfall {
  double missing_m = 0;  ///< Wanted clearance minus actual clearance.
  OsmId upper, lower;
  Vec2 at;
  std::string tags{};  ///< Tags that decide which of both ways is above, as text; empty if no finding names both ways.
};

/// The crossings of a scene.
struct Clearances {
  std::uint64_t crossings = 0;                 ///< Pairs of two lines, or of a line and a water.
  std::vector<ClearanceShortfall> shortfalls;  ///< The largest first.
  /// Shortfalls that the map causes, because its tags do not say which line is above. The largest first.
  std::vector<ClearanceShortfall> contradictions;

  /// Returns the number of shortfalls that are larger than `missing_m`.
  std::uint64_t count_over(double missing_m) const;
  double largest_m() const { return shortfalls.empty() ? 0 : shortfalls.front().missing_m; }
};

/// Measures all crossings of the scene. O(n log n).
///
/// Two lines cross where their axes intersect, or where their widths overlap (tested at most 4 m apart). A pair does
/// not count if the lines are connected close by, if one descends beside the other, if the other continues beside it as
/// a bridge or tunnel, or if both are bridges or both tunnels and lie side by side
/// (ground/profiles/crossings/crossings.h). Ground lines without a profile are at the height of the graded terrain;
/// bridges and tunnels without one are skipped. Each pair of elements counts once, at its worst place.
Clearances measure_clearances(const scene::Scene& scene, int threads);

/// Adds to each shortfall the tags that findings state for its two ways, and moves shortfalls with the finding
/// kLayersContradict to Clearances::contradictions. O(n log n).
/// @param findings  Diagnoses of the run (outputs/findings.h).
Clearances with_findings(Clearances clearances, std::span<const outputs::Finding> findings);

}  // namespace citykiln::verify
