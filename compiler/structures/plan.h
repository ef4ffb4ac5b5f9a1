// Stage 5: what leaves the ground, on the heights that ground/ has decided.
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/geometry/profile.h"
#include "compiler/map/features.h"
#include "compiler/map/heightfield.h"
#include "compiler/structures/recipe.h"

namespace citykiln::structures {

struct Structures {
  std::vector<Span> bridges;  ///< Sorted by id.
  std::vector<Span> tunnels;  ///< Sorted by id; those not bored are in the manifest, but not meshed.
};

/// @param off_ground  Profiles::off_ground of ground/plan_profiles.h: one a track that leaves the ground, in order.
///
/// A span is its track, with its profile and its ends (span_ends.h), still without piers (plan_piers.h). Where the
/// profile is empty it lies at 0. Tunnels that do not lie under the land (bore.h) are not bored, and diagnosed
/// kTunnelNotMeshed. Ledger "structures/bridge", "structures/tunnel". Total. O(n log n) for the sorting.
Structures plan(const map::Features& features, std::span<const Profile> off_ground, const map::Heightfield& heights,
                Report& report);

}  // namespace citykiln::structures
