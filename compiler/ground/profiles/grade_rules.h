// Which lines have profiles, and their grade limits.
#pragma once

#include "compiler/map/land_cover_class.h"

namespace citykiln::ground {

struct GradeRule {
  double limit = 0;     ///< Rise over run.
  double smooth_m = 0;  ///< Smoothing length: waves of the ground shorter than about six times this are not followed.
};

/// Returns true for classes driven on. Foot paths, steps, bridleways and cycle paths apart from streets follow the
/// ground.
bool is_graded(map::LandCoverClass surface);

/// Returns the class's row of grade_rules.inc; for bridges and tunnels of paths, which have none, 50 %: the steps of a
/// footbridge are mostly mapped as part of it, or not at all.
GradeRule grade_rule_of(map::LandCoverClass surface);

}  // namespace citykiln::ground
