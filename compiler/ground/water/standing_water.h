// Standing water and its level by the terrain along its shore.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/ground/cover/shared_borders.h"
#include "compiler/ground/recipe.h"
#include "compiler/map/heightfield.h"

namespace citykiln::ground {

/// The share of a shore that may lie below its water: heightmaps are coarse and have pits, but no lake stands above
/// most of its shore.
inline constexpr double kShoreQuantile = 0.2;
/// Waters with a common border are one unless their shores differ by more than this: then a dam parts them.
inline constexpr double kDam_m = 10;

inline constexpr std::uint32_t kNoWater = 0xffffffffu;

/// One body of standing water: one or more polygons.
struct StandingWater {
  ObjectId id;          ///< The lowest of its polygons'.
  double level_m = 0;   ///< By its shore alone; the sea's is 0. A multiple of kProfileQuantum_m.
  double shore_m = 0;   ///< Length of shore sampled, in whole metres.
  bool is_sea = false;  ///< The sea, and docks and lagoons at its border that lie low.
};

struct StandingWaters {
  std::vector<StandingWater> waters;    ///< Sorted by id.
  std::vector<std::uint32_t> water_of;  ///< Per polygon its water, or kNoWater.
};

/// Returns true for sea, lake, reservoir, basin, pool and dock, not for rivers.
bool is_standing(map::LandCoverClass surface);

/// Samples the terrain along rings and returns quantiles of its height and the length sampled. Left out: edges more
/// than eight times as long as their ring's median (a misplaced node has two), places outside the terrain (rings are
/// trimmed there), and edges in `shared` (sorted), which have water on both sides. If nothing is left, all is sampled.
/// O(n log n).
struct Shore {
  double low_m = 0, high_m = 0;  ///< Heights below and above which kShoreQuantile of the shore lies.
  double length_m = 0;
};
Shore shore_of(std::span<const Ring> rings, const map::Heightfield& heights, std::span<const Edge> shared = {});

/// Groups standing polygons with common borders into waters and finds their levels.
///
/// @param stands  Per polygon: whether it is standing water.
/// Guarantees: does not depend on the order of polygons; at most kShoreQuantile of the shore of a water of one polygon
/// lies below its level. Total. Reports kSeaLevelOffShore for a sea with a shore more than kSeaShore_m from 0.
StandingWaters find_standing_waters(std::span<const LandCoverPolygon> surfaces, const std::vector<bool>& stands,
                                    const map::Heightfield& heights, Report& report);

/// Returns the polygon without misplaced vertices: both edges many times longer than the ring's others, and the terrain
/// there and halfway far from the level. Reports kShoreSpike for each.
LandCoverPolygon without_spikes(LandCoverPolygon surface, double level_m, const map::Heightfield& heights,
                                Report& report);

}  // namespace citykiln::ground
