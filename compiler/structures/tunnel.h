// Generates the meshes of tunnels: the inside of the bore, and the frames around its portals. A span is one bridge or
// one tunnel as a recipe: a road with a profile of heights (recipe.h).
//
//         ___________
//      __|___________|__   frame, in front of the portal
//     |  |  ceiling  |  |
//     |  |           |  |  lining, seen from inside
//     |__|___road____|__|
#pragma once

#include "compiler/map/plane/heightfield.h"
#include "compiler/structures/generate.h"

namespace citykiln::structures {

/// True if a tunnel lies under the terrain and no end ground::enters_from_above(): at least ground::kMinCoveredShare of
/// its ceiling is below the terrain, not counting ground::kPortalLength_m behind each portal. If nothing else is left,
/// its middle counts.
bool is_underground(const Span& tunnel, const map::Heightfield& heights);

/// Generates a tunnel at a tolerance, > 0: road, walls and ceiling that face inwards, open at portals and joints,
/// closed at free ends. Frames around portals are closed. A tunnel that is not is_bored has no mesh. Cannot fail.
GeneratedStructure generate_tunnel(const Span& tunnel, double tolerance_m);

}  // namespace citykiln::structures
