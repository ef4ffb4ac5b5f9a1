// Adds the yards of a map to its features, as tags would give them: areas, barriers, trees and entrances.
#pragma once

#include <vector>

#include "compiler/contract/report.h"
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

/// Returns the features with yards. All that is added has the id of the lot's main building and a part from
/// map::kDerivedPart on; this building is marked with Assumption::kYards and counted. Only lots whose main building has
/// its centroid in the extent get a yard. Mapped car parks without lanes get bays, with the id of the car park.
///
/// Nothing is added over mapped land that is finer than land use, since such land is in no lot; surfaces have lower
/// priorities than it. Nothing that is mapped is changed. The result does not depend on the order of features.
map::Features with_yards(map::Features features, const LotInputs& inputs, Report& report);

}  // namespace citykiln::lots
