// The classes of lines that have profiles, and their grade limits.
#pragma once

#include "compiler/map/land_cover_class.h"

namespace citykiln::ground {

/// The limits of one class.
struct GradeRule {
  double limit = 0;     ///< Largest rise over run.
  double smooth_m = 0;  ///< Smoothing length: profiles do not follow waves shorter than about six times this.
};

/// True for classes of roads and rails, which have height profiles on the ground too. Foot paths, steps, bridleways and
/// separate cycle paths follow the ground, except at bridges and tunnels (plan_paths.h).
bool has_profile(map::LandCoverClass surface);

/// Returns the class's row of grade_rules.inc. Paths have no row; their bridges and tunnels have a limit of 50 %, since
/// the steps of a footbridge are mostly mapped as part of it, or not at all.
GradeRule grade_rule_of(map::LandCoverClass surface);

}  // namespace citykiln::ground
