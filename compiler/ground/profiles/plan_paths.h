// Foot bridges, underpasses and the paths that lead up and down to them, on the ground that roads and water have cut.
//
// Paths follow the ground as it is. So they are decided last, when that ground is known: a foot bridge comes down on
// the pavement beside a street's cutting, not on the heightmap above it. Where there is no room below or above, the
// paths that lead up (approach_paths.h) climb and go down with it.
#pragma once

#include <span>

#include "compiler/ground/profiles/plan_profiles.h"

namespace citykiln::ground {

/// What streams and waters the ground has, and how high it is without roads.
struct TerrainWithoutRoads {
  std::span<const roads::Strip> streams;
  std::span<const LandCoverPolygon> waters;
  const map::Heightfield& heights;
};

/// Gives paths that leave the ground, and those that lead up to them, their profiles.
///
/// @param profiles  Of all that has heights of its own, decided; of paths off the ground any.
///
/// Guarantees: what is no path stays as it is; paths meet at nodes of the map to kKnotError_m, what is no path to twice
/// kKnotError_m. Paths of the ground that need not climb keep no profile. Of all lines it is told what they lack:
/// kClearanceNotMet. Total. Reach: that of approach_paths(), the length of what is off the ground as far as
/// kSpanEndRadius_m, and kGrading_m.
Profiles plan_paths(const map::Features& features, Profiles profiles, const TerrainWithoutRoads& terrain,
                    Report& report);

}  // namespace citykiln::ground
