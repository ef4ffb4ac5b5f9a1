#include "compiler/roads/plan.h"

#include "compiler/map/ways/passageways.h"
#include "compiler/roads/roads_on_ground.h"
#include "compiler/roads/width_limits/limit_widths.h"

namespace citykiln::roads {

RoadPlan plan(const map::FeatureView& features, Report& report) {
  RoadPlan plan;
  plan.passageways = map::plan_passageways(features, report);
  const std::vector<Road> wide = roads_on_ground(features, report);
  plan.junctions = plan_junctions(wide, report);
  plan.roads = limit_widths(wide, plan.junctions, features.footprints,
                            ways_through_buildings(features.tracks, plan.passageways), report);
  return plan;
}

}  // namespace citykiln::roads
