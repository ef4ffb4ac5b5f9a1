// Hedges beside roads outside of towns.
#pragma once

#include <vector>

#include "compiler/fields/add_fields.h"
#include "compiler/fields/field_barriers.h"

namespace citykiln::fields {

/// The width of the verge between a road and its hedge, in metres: the hedge's axis is that far from the edge.
inline constexpr double kLaneVerge_m = 2;

/// Returns hedges on both sides of secondary, tertiary and unclassified roads where fields have hedges
/// (field_rules.h), on each stretch of kShortestLaneHedge_m or more where BarrierPlaces::is_beside_lane(). Ids are of
/// roadside_id(); sorted by road. Roads with hedges are counted as Assumption::kRoadsides. O(length of roads).
std::vector<map::Barrier> lane_hedges(const FieldInputs& inputs, const BarrierPlaces& places, Report& report);

/// The shortest hedge beside a road, in metres.
inline constexpr double kShortestLaneHedge_m = 20;

}  // namespace citykiln::fields
