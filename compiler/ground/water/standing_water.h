// Water that stands, and how high it stands by the land along its shore.
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
/// Waters that share a border are one, unless the land says that they lie farther apart than this: then a dam parts
/// them.
inline constexpr double kDam_m = 10;

inline constexpr std::uint32_t kNoWater = 0xffffffffu;

/// One body of standing water, of one or more surfaces.
struct StandingWater {
  ObjectId id;          ///< The lowest of its surfaces'.
  double level_m = 0;   ///< By its shore alone; the sea's is 0. A multiple of kProfileQuantum_m.
  double shore_m = 0;   ///< Of shore that was asked, whole.
  bool is_sea = false;  ///< The sea, and docks and lagoons that share its border and lie low.
};

struct StandingWaters {
  std::vector<StandingWater> waters;    ///< Sorted by id.
  std::vector<std::uint32_t> water_of;  ///< For each surface its water, or kNoWater.
};

/// Sea, lake, reservoir, basin, pool, dock; not rivers.
bool is_standing(map::LandCoverClass surface);

/// The height below which kShoreQuantile of the land along the rings lies, and how long the shore is that was asked.
/// Left out are edges more than eight times as long as their ring's median (a node in the sky has two), what lies
/// outside the heightfield (there rings are trimmed), and the edges `shared` with water on their other side (sorted).
/// Without anything left, all of it is asked. O(n log n).
struct Shore {
  double low_m = 0, high_m = 0;  ///< Where kShoreQuantile lies below, and where as much lies above.
  double length_m = 0;
};
Shore shore_of(std::span<const Ring> rings, const map::Heightfield& heights, std::span<const Edge> shared = {});

/// Groups standing surfaces that share borders into waters, and finds their levels.
///
/// @param stands  For each surface, whether it is standing water.
/// Guarantees: independent of the surfaces' order; at most kShoreQuantile of a water's shore lies below its level,
/// where it is one surface. Total. A sea whose shore lies more than kSeaShore_m from 0 is diagnosed kSeaLevelOffShore.
StandingWaters find_standing_waters(std::span<const LandCoverPolygon> surfaces, const std::vector<bool>& stands,
                                    const map::Heightfield& heights, Report& report);

/// The surface without the vertices that are far out of place: both of their edges many times longer than the ring's
/// others, and the land there and on the way far from the level. Mended vertices are diagnosed kShoreSpike.
LandCoverPolygon without_spikes(LandCoverPolygon surface, double level_m, const map::Heightfield& heights,
                                Report& report);

}  // namespace citykiln::ground
