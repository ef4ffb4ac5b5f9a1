// Heights along every road and rail, decided once, when the map is compiled.
//
// One network of all that is driven on, and of all bridges and tunnels (profile_graph.h), goes through five steps, each
// a function of heights by node, each with a hard reach:
//
//     initial_heights      what the heightmap says, without spikes; between ends of what leaves the ground the line
//     smooth_heights    smooth, as the class wants it
//     fit_junction_planes   junctions are plates
//     limit_grades      no steeper than the class allows
//     clear_crossings   bridges rise, tunnels go down (and junctions are plates again, under their grades; what that
//                       takes back of a clearance is asked for once more)
//
// and is written down as few knots (profile_knots.h). Foot bridges, underpasses and the paths that lead up to them come
// last, on the ground that all this has cut (plan_paths.h).
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/contract/stable_id.h"
#include "compiler/geometry/profile.h"
#include "compiler/ground/recipe.h"
#include "compiler/map/features.h"
#include "compiler/roads/junctions/junction.h"

namespace citykiln::ground {

/// Where nothing leaves the ground, nothing farther than this matters: the steps' reaches added up (smoothing, plates
/// twice, grades twice). Each storey of bridges or tunnels adds the length of two ramps, 850 m for a railway's and half
/// as much for a road's, and once more the reach of plates and grades; kSpanEndRadius_m is how far their ends are
/// looked for.
inline constexpr double kProfileRadius_m = 2560;

/// One line over another, or over a water or under a path of the ground.
struct ClearanceShortfall {
  OsmId upper, lower;      ///< None for what has no profile.
  double shortfall_m = 0;  ///< Where most is missing; not above zero where there is room everywhere.
};

struct Profiles {
  std::vector<roads::Road> roads;              ///< Those given, with their profiles.
  std::vector<Profile> off_ground;             ///< One a track that leaves the ground, in the order of features.tracks.
  std::vector<ClearanceShortfall> shortfalls;  ///< One a pair, sorted by the upper's id, those that are none last.
};

/// @param streams  With profiles; without one a stream lies on the heightmap.
/// @param waters   Those without a level are not looked at.
/// @param limit_scale  Of all grade limits; for charts.
///
/// Guarantees: where ways share a node their heights there are the same, to kKnotError_m; nodes of one junction lie on
/// one plane; a bridge that crosses nothing, or has room, lies on the smooth line between its ends; spikes of the
/// heightmap (20 to 500 m at one vertex) move no profile by more than 8 m; a road at height 0 all along, over a
/// heightmap that is 0 there, has no knots. Does not depend on the order of tracks and roads. Diagnosed: kTooSteep,
/// kClearanceNotMet, kBridgeWithoutGround. Total. Reach: kProfileRadius_m.
Profiles plan_profiles(const map::Features& features, std::vector<roads::Road> roads,
                       std::span<const roads::Junction> junctions, std::span<const roads::Strip> streams,
                       std::span<const LandCoverPolygon> waters, const map::Heightfield& heights, Report& report,
                       double limit_scale = 1);

}  // namespace citykiln::ground
