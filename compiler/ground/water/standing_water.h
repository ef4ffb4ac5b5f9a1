// Finds bodies of standing water, and their levels from the terrain along the shore.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/ground/cover/shared_borders.h"
#include "compiler/ground/recipe.h"
#include "compiler/map/plane/heightfield.h"

namespace citykiln::ground {

/// The share of a shore that may be below its water. Heightmaps are coarse and have pits, but no lake is above most of
/// its shore.
inline constexpr double kShoreQuantile = 0.2;
/// Polygons with a common border are one water if their shores differ by at most this. A larger difference means a dam.
inline constexpr double kDam_m = 10;

inline constexpr std::uint32_t kNoWater = 0xffffffffu;

/// One body of standing water: one or more polygons.
struct StandingWater {
  ObjectId id;          ///< The lowest id of its polygons.
  double level_m = 0;   ///< Level from the shore, 0 for the sea; a multiple of kProfileQuantum_m.
  double shore_m = 0;   ///< Length of the sampled shore, in whole metres.
  bool is_sea = false;  ///< True for the sea, and for docks and lagoons at its border with shores up to 8 m.
};

struct StandingWaters {
  std::vector<StandingWater> waters;    ///< Sorted by id.
  std::vector<std::uint32_t> water_of;  ///< Per polygon the index of its water, or kNoWater.
};

/// True for sea, lake, reservoir, basin, pool and dock; false for rivers.
bool is_standing(map::LandCoverClass surface);

/// Quantiles of the terrain's height along a shore, and the sampled length.
struct Shore {
  double low_m = 0, high_m = 0;  ///< A share kShoreQuantile of the shore is below low_m, the same above high_m.
  double length_m = 0;
};
/// Samples the terrain along rings. Left out are edges more than eight times as long as their ring's median (a
/// misplaced node has two), places outside the terrain, where rings are trimmed, and edges in `shared` (sorted), which
/// have water on both sides. If nothing is left, all is sampled. O(n log n).
Shore shore_of(std::span<const Ring> rings, const map::Heightfield& heights, std::span<const Edge> shared = {});

/// Groups polygons of standing water with common borders into waters and finds their levels.
///
/// @param stands  Per polygon: true if it is standing water.
/// Guarantees: does not depend on the order of polygons; for a water of one polygon, at most kShoreQuantile of the
/// shore is below its level. Reports kSeaLevelOffShore for a sea whose shore (Shore::low_m) is more than 8 m
/// from 0.
StandingWaters find_standing_waters(std::span<const LandCoverPolygon> surfaces, const std::vector<bool>& stands,
                                    const map::Heightfield& heights, Report& report);

/// Returns the polygon without misplaced vertices, for which both edges are many times longer than the ring's other
/// edges, and the terrain at the vertex and in the middle of the edges is far from the level. Reports kShoreSpike for
/// each.
LandCoverPolygon without_spikes(LandCoverPolygon surface, double level_m, const map::Heightfield& heights,
                                Report& report);

}  // namespace citykiln::ground
