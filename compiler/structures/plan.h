// Plans bridges and tunnels: makes a recipe (a span) from each track that leaves the ground, with the heights that
// ground/ has decided.
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/geometry/box.h"
#include "compiler/geometry/profile.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/map/features.h"
#include "compiler/map/plane/heightfield.h"
#include "compiler/structures/recipe.h"

namespace citykiln::structures {

/// Spans, without or with their piers.
struct Structures {
  std::vector<Span> bridges;  ///< Sorted by id.
  std::vector<Span> tunnels;  ///< Sorted by id. Tunnels that are not is_bored have no mesh.
};

/// Returns the spans of all tracks that leave the ground, with profiles and ends (span_ends.h), and parapet gaps
/// (plan_parapet_gaps.h), but without piers: these stand on the ground that the spans grade.
///
/// @param off_ground  Profiles::off_ground: one profile for each track that leaves the ground, in the order of
///                    features.tracks. An empty profile puts the span at height 0.
/// @param heights     The terrain before grading.
///
/// Tunnels that do not lie under the terrain (is_underground()) are diagnosed kTunnelNotMeshed. Ledger
/// "structures/bridge", "structures/tunnel". Cannot fail. O(n log n).
Structures plan(const map::FeatureView& features, std::span<const Profile> off_ground, const map::Heightfield& heights,
                Report& report);

/// Returns the spans of the extent (within_extent.h), with their piers (plan_piers.h).
/// @param graded     The terrain that these spans have graded.
/// @param obstacles  The land cover of the whole map.
Structures with_piers(const Structures& spans, const ground::GradedTerrain& graded,
                      std::span<const ground::LandCoverPolygon> obstacles, const Box2& extent, Report& report);

}  // namespace citykiln::structures
