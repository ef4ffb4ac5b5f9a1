// Vertical clearance where a line passes over another line or over water without a junction, against the wanted
// clearance (ground/profiles/crossings.h). Uses recipes only, independently of the crossings that the planner found.
//
//     ====X====  a deck passes over ground roads, paths and water, over tunnels, and over decks with a lower layer tag
//     ----X----  ground roads and paths pass over tunnels
//     ....X....  a tunnel passes over tunnels with a lower layer tag
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "compiler/scene/scene.h"
#include "compiler/verify/findings.h"

namespace citykiln::verify {

/// A crossing that misses the wanted clearance by more than ground::kShortfallMargin_m.
struct ClearanceShortfall {
  double missing_m = 0;
  OsmId upper, lower;
  Vec2 at;
  std::string tags{};  ///< Of both, those that decide which is above; empty if no finding names them.
};

struct Clearances {
  std::uint64_t crossings = 0;                 ///< Pairs of lines, or of a line and a water.
  std::vector<ClearanceShortfall> shortfalls;  ///< The largest first.
  /// Those that the map explains: its tags do not say which line is above. The largest first.
  std::vector<ClearanceShortfall> contradictions;

  /// Number of shortfalls that are larger than this.
  std::uint64_t count_over(double missing_m) const;
  double largest_m() const { return shortfalls.empty() ? 0 : shortfalls.front().missing_m; }
};

/// Measures all crossings of the scene. Two lines cross where their axes intersect, or where one runs within the
/// other's width (tested every 4 m), unless they are connected close by, one descends beside the other, the other goes
/// on as a bridge or tunnel beside it, or both are bridges or both tunnels and side by side
/// (ground/profiles/crossings.h). Lines without a profile lie on the graded terrain. Each crossing counts once, in the
/// tile that contains it. O(n log n).
Clearances measure_clearances(const scene::Scene& scene, int threads);

/// Returns the measures with the tags that findings quote, and with the shortfalls of pairs that a finding
/// kLayersContradict names among the contradictions. O(n log n).
Clearances explained(Clearances clearances, std::span<const Finding> findings);

}  // namespace citykiln::verify
