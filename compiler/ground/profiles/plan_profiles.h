// Plans the heights along every road and rail, once, when the map is compiled.
//
// One graph of everything that is driven on and of all bridges and tunnels (profile_graph.h) goes through six steps.
// Each is a function of heights by node with a finite influence radius:
//
//     initial_heights      the filtered terrain; on bridges and in tunnels the line between their ends
//     smooth_heights       smooth enough for the class
//     fit_junction_planes  flat junctions
//     limit_grades         no steeper than the class allows
//     clear_crossings      bridges rise, tunnels fall
//     enforce_clearances   what planes and limits took back of clearances
//
// Clearing tilts junctions and makes ramps, so planes and limits are applied again before the last step. The result is
// stored as few knots (profile_knots.h). Foot bridges, underpasses and their approaches come last, on the terrain that
// all this has graded (plan_paths.h).
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/contract/stable_id.h"
#include "compiler/geometry/profile.h"
#include "compiler/ground/profiles/profile_graph.h"
#include "compiler/ground/recipe.h"
#include "compiler/map/features.h"
#include "compiler/roads/junctions/junction.h"

namespace citykiln::ground {

/// Without bridges and tunnels nothing farther than this matters: the sum of the steps' radii (smoothing, planes twice,
/// limits twice). Each storey of bridges or tunnels adds two ramps, 850 m for a railway and half of that for a road,
/// and the radii of planes and limits again; each round of enforce_clearances() adds one more ramp. Their ends are
/// searched within kSpanEndRadius_m.
inline constexpr double kProfileRadius_m = 2560;

/// The shortfall of one line over another, over water, or under a path on the ground.
struct ClearanceShortfall {
  OsmId upper, lower;
  double shortfall_m = 0;         ///< The largest; <= 0 where there is enough clearance everywhere.
  bool is_contradictory = false;  ///< Whether tags do not say which is above (layers_contradict).
};

struct Profiles {
  std::vector<roads::Road> roads;   ///< Those given, with their profiles.
  std::vector<Profile> off_ground;  ///< One per track that leaves the ground, in the order of features.tracks.
  std::vector<ClearanceShortfall> shortfalls;  ///< One per pair, sorted by ids.
};

/// Returns the profile of a way.
const Profile& profile_of(const Profiles& profiles, const GraphWay& way);

/// Returns its height at a distance along the way; 0 without profile.
double height_m_of(const Profiles& profiles, const GraphWay& way, double at_m);

/// Plans all profiles.
/// @param streams  With profiles; a stream without one lies on the terrain.
/// @param waters   Those without a level are ignored.
/// @param limit_scale  Factor on all grade limits; for charts.
///
/// Guarantees: ways have the same height at a common node, within kKnotError_m; nodes of one junction lie on one plane;
/// a bridge with enough clearance lies on the smooth line between its ends; summits of 20 to 500 m at one vertex of the
/// terrain move no profile by more than 8 m; a road of at most kKnotStretch_m at height 0 on terrain at height 0, well
/// beyond kGrading_m from all that lies at other heights, has no knots. Does not depend on the order of tracks and
/// roads. Reports kTooSteep, kClearanceNotMet or kLayersContradict, kCrossingWithoutOrder, kTunnelLowered,
/// kBridgeWithoutGround. Total. Depends on what lies within kProfileRadius_m.
Profiles plan_profiles(const map::Features& features, std::vector<roads::Road> roads,
                       std::span<const roads::Junction> junctions, std::span<const roads::Strip> streams,
                       std::span<const LandCoverPolygon> waters, const map::Heightfield& heights, Report& report,
                       double limit_scale = 1);

}  // namespace citykiln::ground
