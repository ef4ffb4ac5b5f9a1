// Stage 5: what leaves the ground, on the heights that ground/ has decided.
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/geometry/profile.h"
#include "compiler/map/features.h"
#include "compiler/structures/recipe.h"

namespace citykiln::structures {

struct Structures {
  std::vector<Span> bridges;  ///< Sorted by id.
  std::vector<Span> tunnels;  ///< Sorted by id; in the manifest, not meshed (diagnosed kTunnelNotMeshed).
};

/// @param off_ground  Profiles::off_ground of ground/plan_profiles.h: one a track that leaves the ground, in order.
///
/// A span's axis is its track's, with its profile's heights, and has a point at each knot. Where the profile is empty
/// it lies at 0. Ledger "structures/bridge", "structures/tunnel". Total. O(n log n) for the sorting.
Structures plan(const map::Features& features, std::span<const Profile> off_ground, Report& report);

}  // namespace citykiln::structures
