// Puts houses on residential lots that have no building (--fill lots).
//
// | step | where |
// |---|---|
// | land without buildings is divided into lots | parcels/empty_lots.h |
// | a row of usual sizes is drawn for each side of a street | houses.inc |
// | the largest rectangle of the lot that keeps its distances | house_room.h |
// | the rules of the row divide it into bodies | grammars/rules/lots |
// | roofs, styles, pavements beside them: as for mapped houses | assume/assume.h |
#pragma once

#include <map>
#include <string>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/contract/result.h"
#include "compiler/lots/lot_inputs.h"
#include "compiler/map/features.h"
#include "grammars/language/read_rules.h"

namespace citykiln::lots {

/// The rules of houses by their files, such as "lots/detached.cga".
///
/// A derivation starts from the shape Lot: the rectangle of room_for_house(), its first edge on the street. Its
/// attribute `levels` is the number of storeys. Each terminal with a bottom face on the ground becomes a building of
/// its height. Its name says which: House, Flats, Shop or Garage; other names are left out. A lot has at most 2,000
/// shapes.
using HouseRules = std::map<std::string, grammars::Program, std::less<>>;

/// Reads the rules that houses.inc names. Errors: those of read_rules().
Result<HouseRules> read_house_rules(const grammars::Loader& load);

/// Returns the footprints, sorted by id, with houses on lots without buildings whose middle is residential land, or
/// land of no mapped use beside a residential street. They are footprints of a type of their own (OsmType::kLot),
/// numbered by the ids of lots, and marked with Assumption::kHouses.
///
/// None stands on anything that is mapped, and none where the lot has no room for one. They have no roofs yet. A house
/// depends on what lies within parcels::kInfluenceRadius_m. The result does not depend on the order of features.
/// @param rules  The result of read_house_rules().
std::vector<map::Footprint> with_houses(const map::FeatureView& features, const LotInputs& inputs,
                                        const HouseRules& rules, Report& report);

}  // namespace citykiln::lots
