// Plans bridges and tunnels on the heights that ground/ has decided.
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/geometry/profile.h"
#include "compiler/map/features.h"
#include "compiler/map/plane/heightfield.h"
#include "compiler/structures/recipe.h"

namespace citykiln::structures {

struct Structures {
  std::vector<Span> bridges;  ///< Sorted by id.
  std::vector<Span> tunnels;  ///< Sorted by id. Tunnels that are not is_bored have no mesh.
};

/// Returns the spans of all tracks off the ground, with profiles and ends (span_ends.h), without parapet gaps and
/// piers.
///
/// @param off_ground  Profiles::off_ground: one profile for each track off the ground, in their order. An empty one
///                    puts the span at height 0.
///
/// Tunnels that do not lie under the terrain (is_underground()) are diagnosed kTunnelNotMeshed. Ledger
/// "structures/bridge", "structures/tunnel". Cannot fail. O(n log n).
Structures plan(const map::Features& features, std::span<const Profile> off_ground, const map::Heightfield& heights,
                Report& report);

}  // namespace citykiln::structures
