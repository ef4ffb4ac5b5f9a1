// Adds the yards of a map to its features, as tags would give them: areas, barriers, trees and entrances.
#pragma once

#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/lots/lot_inputs.h"
#include "compiler/lots/plan_lots.h"
#include "compiler/map/features.h"
#include "compiler/parcels/divide.h"

namespace citykiln::lots {

/// Yards depend on the lots beside theirs, whose openings and borders they share, and lots on parcels'
/// kInfluenceRadius_m. A lot reaches up to 2 · kDepth_m across its block, and so does each neighbour.
inline constexpr double kYardRadius_m = parcels::kInfluenceRadius_m + 4 * parcels::kDepth_m;

/// Returns the lots with buildings of a map (plan_lots.h).
std::vector<Lot> lots_of_map(const map::FeatureView& features, const LotInputs& inputs);

/// The lists of a map that yards change, with what they add. Each is whole, and sorted by id.
struct Yards {
  std::vector<map::Footprint> footprints;
  std::vector<map::AreaFeature> areas;
  std::vector<map::SportsArea> sports_areas;
  std::vector<map::Barrier> barriers;
  std::vector<map::PointFeature> points;
};

/// Returns the features with these lists in place of theirs. `yards` must outlive the result.
map::FeatureView seen_with(map::FeatureView features, const Yards& yards);

/// Returns the features with yards. All that is added has the id of the lot's main building and a part from
/// kFirstDerivedPart on (contract/derived_id.h); this building is marked with Assumption::kYards and counted. Only lots
/// whose main building has its centroid in the extent get a yard. Mapped car parks without lanes get bays, with the id
/// of the car park.
///
/// Nothing is added over mapped land that is finer than land use, since such land is in no lot; surfaces have lower
/// priorities than it. Nothing that is mapped is changed. The result does not depend on the order of features.
Yards with_yards(const map::FeatureView& features, const LotInputs& inputs, Report& report);

}  // namespace citykiln::lots
