// Hedges beside roads outside of towns.
#pragma once

#include <vector>

#include "compiler/fields/add_fields.h"
#include "compiler/fields/field_barriers.h"

namespace citykiln::fields {

/// The distance in metres from the kerb of a road to the axis of its hedge.
inline constexpr double kLaneVerge_m = 2;

/// Returns hedges on both sides of secondary, tertiary, unclassified and residential roads where
/// FieldRule::border is kHedge at the road's middle point. They stand on each stretch of at least
/// kShortestLaneHedge_m where BarrierPlaces::is_beside_lane(). Ids are those of roadside_id(), from
/// 0 on for each road. The order is that of the roads. Each way with a hedge is counted as
/// Assumption::kRoadsides. O(length of roads).
std::vector<map::Barrier> lane_hedges(const FieldInputs& inputs, const BarrierPlaces& places, Report& report);

/// The shortest hedge beside a road, in metres.
inline constexpr double kShortestLaneHedge_m = 20;

}  // namespace citykiln::fields
