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

/// Returns the lots with buildings of a map: the result of plan_lots() (plan_lots.h), whose order it has.
std::vector<Lot> lots_of_map(const map::FeatureView& features, const LotInputs& inputs);

/// The lists of a map to which yards add: the mapped features and those of yards together, each sorted by id.
struct Yards {
  std::vector<map::Footprint> footprints;
  std::vector<map::AreaFeature> areas;
  std::vector<map::SportsArea> sports_areas;
  std::vector<map::Barrier> barriers;
  std::vector<map::PointFeature> points;
  std::vector<Yard> recipes;  ///< Areas, barriers and plants of yards were drawn from them; sorted by building.
};

/// Returns the features with the lists of `yards` in place of theirs. The result refers to `yards`, which must outlive
/// it unchanged.
map::FeatureView seen_with(map::FeatureView features, const Yards& yards);

/// Returns the features with a yard for each lot that has a rule (yard_rules.h) and whose main building has its
/// centroid in the extent. A yard is areas with a surface, barriers, trees and shrubs, and an entrance at the lot's
/// door where none is mapped. Each of these has the id of the main building, with a part from kFirstDerivedPart on
/// (contract/derived_id.h). Ids are unique within one list only.
///
/// Car parks also get bays, as a SportsArea "parking" with the id of the area: those of yards, and mapped ones that no
/// mapped road or drive enters. The main buildings of lots with yards are marked with Assumption::kYards. They and
/// these mapped car parks are counted in the report as assumed.
///
/// Nothing is added over mapped land that is finer than land use, since such land is in no lot; surfaces of yards have
/// lower priorities than it. Yards are what draw_yard() draws of `recipes`, but for entrances and for bays of mapped
/// car parks. No mapped feature is changed, but for the mark. The result does not depend on the order of features.
/// Cannot fail. Cost: that of parcels::divide() and plan_lots(), plus O(n log n).
Yards with_yards(const map::FeatureView& features, const LotInputs& inputs, Report& report);

}  // namespace citykiln::lots
