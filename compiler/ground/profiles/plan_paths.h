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
  std::span<const Landform> landforms{};
};

/// Plans the profiles of paths that leave the ground, and of approach paths that must move. An approach path leads up
/// to a bridge, down to a tunnel, or below a bridge.
///
/// @param profiles  Final profiles of all other lines. The profiles of paths off the ground are replaced.
/// @param terrain   Terrain and water before roads grade it.
///
/// Guarantees: other lines stay. At map nodes profiles of paths have equal heights within kKnotError_m, and meet other
/// lines within twice that. An approach path gets a profile only if clearances move it by more than kKnotError_m, if
/// clearances and grade limits together move it by more than 0.25 m (a step of stairs), or if it passes below another
/// line. Reports kClearanceNotMet or kLayersContradict for all lines, and kCrossingWithoutOrder. Cannot fail. Depends
/// on data within the distances of approach_paths(), kSpanEndRadius_m along bridges and tunnels, and kGrading_m.
Profiles plan_paths(const map::FeatureView& features, Profiles profiles, const TerrainWithoutRoads& terrain,
                    Report& report);

}  // namespace citykiln::ground
