// Plans profiles of foot bridges, underpasses and the paths that lead up and down to them.
//
// They are planned last, on the terrain that roads, their tunnels and water have graded: a foot bridge comes down on
// the pavement beside a street's cutting, not on the heightmap above it. If a foot bridge or underpass moves for a
// clearance, its approach paths (approach_paths.h) move with it.
#pragma once

#include <span>

#include "compiler/ground/profiles/plan_profiles.h"

namespace citykiln::ground {

/// Watercourses, standing water and terrain, before grading.
struct TerrainWithoutRoads {
  std::span<const roads::Strip> streams;
  std::span<const LandCoverPolygon> waters;
  const map::Heightfield& heights;
};

/// Plans the profiles of paths that leave the ground, and of approach paths that must move.
///
/// @param profiles  Final profiles of all other lines; profiles of paths off the ground are replaced.
///
/// Guarantees: other lines stay; at map nodes paths meet within kKnotError_m, and other lines within twice that.
/// Approach paths that need not move get no profile, unless they pass below another line. Reports kClearanceNotMet or
/// kLayersContradict for all lines, and kCrossingWithoutOrder. Cannot fail. Depends on data within the distances of
/// approach_paths(), kSpanEndRadius_m along bridges and tunnels, and kGrading_m.
Profiles plan_paths(const map::Features& features, Profiles profiles, const TerrainWithoutRoads& terrain,
                    Report& report);

}  // namespace citykiln::ground
