// Plans roads: tracks on the ground become roads and junctions, no wider than the buildings beside them allow.
#pragma once

#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/map/features.h"
#include "compiler/roads/junctions/junction.h"
#include "compiler/roads/recipe.h"

namespace citykiln::roads {

/// The roads on the ground, without heights: ground::plan_profiles() decides these.
struct RoadPlan {
  std::vector<Road> roads;                   ///< Sorted by id, not wider than the buildings beside them allow.
  std::vector<Junction> junctions;           ///< The junctions of these roads, at full width.
  std::vector<map::Passageway> passageways;  ///< Sorted by building, then by way.
};

/// Plans passageways, roads, junctions and width limits, in this order.
RoadPlan plan(const map::FeatureView& features, Report& report);

}  // namespace citykiln::roads
