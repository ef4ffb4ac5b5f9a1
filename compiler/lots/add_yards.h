// Adds the yards of a map to its features, as tags would give them: areas, barriers, trees and entrances.
#pragma once

#include <cstdint>
#include <span>

#include "compiler/contract/report.h"
#include "compiler/lots/plan_lots.h"
#include "compiler/map/features.h"
#include "compiler/parcels/divide.h"
#include "compiler/roads/junctions/junction.h"
#include "compiler/roads/recipe.h"

namespace citykiln::lots {

/// The inputs of yards beside the features.
struct YardSite {
  std::span<const roads::Road> roads;          ///< Planned roads with their pavements.
  std::span<const roads::Junction> junctions;  ///< The junctions of these roads.
  std::span<const OsmId> private_ways;         ///< Sorted (map/private_ways.h).
  const ClimateAt& climate_at;
  std::uint64_t seed = 0;
  int threads = 0;
};

/// Yards depend on the lots beside theirs, whose openings and borders they share, and lots on parcels'
/// kInfluenceRadius_m. Yards are at most two lots wide.
inline constexpr double kYardRadius_m = parcels::kInfluenceRadius_m + 4 * parcels::kDepth_m;

/// Returns the lots with buildings of a map (plan_lots.h), and counts lots by kind in the ledger "lots/…".
std::vector<Lot> lots_of_map(const map::Features& features, const YardSite& site);

/// Returns the features with yards. All that is added has the id of the lot's main building and a part from
/// map::kDerivedPart on; this building is marked with Assumption::kYards and counted.
///
/// Nothing is added over mapped land that is finer than land use, since such land is in no lot; surfaces have lower
/// priorities than it. Nothing that is mapped is changed. The result does not depend on the order of features.
map::Features with_yards(map::Features features, const YardSite& site, Report& report);

}  // namespace citykiln::lots
