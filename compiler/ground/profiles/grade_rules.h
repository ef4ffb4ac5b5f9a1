// Which lines have heights of their own, and how steep each may be.
#pragma once

#include "compiler/map/land_cover_class.h"

namespace citykiln::ground {

struct GradeRule {
  double limit = 0;     ///< Rise over run.
  double smooth_m = 0;  ///< Waves of the ground shorter than some six times this are not followed.
};

/// True for what is driven on. Foot paths, steps, bridleways and cycle paths apart from streets follow the ground.
bool is_graded(map::LandCoverClass surface);

/// The row of grade_rules.inc; what has none, and leaves the ground, is a path's bridge or tunnel: 50 %, as a
/// footbridge's steps are mostly mapped as part of it, or not at all.
GradeRule grade_rule_of(map::LandCoverClass surface);

}  // namespace citykiln::ground
