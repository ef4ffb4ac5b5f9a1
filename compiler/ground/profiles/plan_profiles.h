// Plans the heights along every road and rail, once, when the map is compiled.
//
// One graph of all roads, rails, bridges and tunnels (profile_graph.h) goes through seven steps. Each step is a
// function of heights by node with a finite influence radius:
//
//     initial_heights      the filtered terrain; on bridges and in tunnels the line between their ends
//     smooth_heights       smooth enough for the class (smooth_profile.h)
//     fit_junction_planes  flat junctions (junction_planes.h)
//     limit_grades         no steeper than the class allows (grade_limits.h, grade_rules.inc)
//     lower_mouths         lines go down to tunnels in flat land (lower_mouths.h)
//     clear_crossings      bridges rise, tunnels fall (clearances.h)
//     enforce_clearances   restores clearances that planes and limits have reduced
//
// Clearing tilts junctions and makes ramps, so planes and limits are applied again before the last step. The result is
// stored as few knots (profile_knots.h). Roads that lie on the land correct the heightmap (known_lines.h). Foot
// bridges, underpasses and their approaches are planned afterwards, on the graded terrain (plan_paths.h).
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/contract/stable_id.h"
#include "compiler/geometry/profile.h"
#include "compiler/ground/correction/known_line.h"
#include "compiler/ground/landforms/recipe.h"
#include "compiler/ground/profiles/graph/profile_graph.h"
#include "compiler/ground/recipe.h"
#include "compiler/map/features.h"
#include "compiler/roads/junctions/junction.h"

namespace citykiln::ground {

/// The distance within which data can change a height, without bridges and tunnels: the sum of the steps' radii
/// (smoothing, planes twice, limits twice). Each storey of bridges or tunnels adds two ramps, 850 m for a railway and
/// half as much for a road, and the radii of planes and limits again; each round of enforce_clearances() adds one more
/// ramp. Ends of bridges and tunnels are searched within kSpanEndRadius_m.
inline constexpr double kProfileRadius_m = 2560;

/// The missing clearance of one line over another, over water, or under a path on the ground.
struct ClearanceShortfall {
  OsmId upper, lower;
  double shortfall_m = 0;         ///< The largest one; <= 0 if there is enough clearance everywhere.
  bool is_contradictory = false;  ///< Result of layers_contradict().
};

/// The planned heights of all lines. A profile is a list of knots, heights at distances along a line, linear in
/// between.
struct Profiles {
  std::vector<roads::Road> roads;   ///< The roads as they are built: the planned ones, with their profiles.
  std::vector<Profile> off_ground;  ///< One per track that leaves the ground, in the order of features.tracks.
  std::vector<ClearanceShortfall> shortfalls;  ///< One per pair, sorted by ids.
};

/// Returns the profile of a way of the graph.
const Profile& profile_of(const Profiles& profiles, const GraphWay& way);

/// Returns the height of a way at a distance along it; 0 without profile.
double height_m_of(const Profiles& profiles, const GraphWay& way, double at_m);

/// The profiles of all lines but paths off the ground, and the heights that they give to the land.
struct LineProfiles {
  Profiles profiles;
  std::vector<KnownLine> known;  ///< Result of known_lines().
};

/// Plans profiles as plan_profiles() does, without its last step, plan_paths(), which may then get land that is
/// corrected by the known lines.
LineProfiles plan_line_profiles(const map::FeatureView& features, std::span<const roads::Road> roads,
                                std::span<const roads::Junction> junctions, std::span<const roads::Strip> streams,
                                std::span<const LandCoverPolygon> waters, const map::Heightfield& heights,
                                Report& report, std::span<const Landform> landforms = {});

/// Plans all profiles.
/// @param streams    Watercourses with their profiles; a stream without one lies on the terrain.
/// @param waters     Water polygons; polygons without a level are ignored.
/// @param heights    The terrain.
/// @param landforms  Retaining walls, dykes, piers and others; roads have the height of their side.
///
/// Guarantees: ways have equal heights at a common node, and roads where they cross on the ground off junctions, within
/// kKnotError_m; nodes of one junction lie on one plane; a bridge with enough clearance lies on the smooth line between
/// its ends; a summit of 20 to 500 m at a single vertex of the terrain moves no profile by more than 8 m; a road of at
/// most kKnotStretch_m at height 0 on terrain at height 0, well beyond kGrading_m from anything at other heights, has
/// no knots. The order of tracks and roads does not matter. Reports kTooSteep, kStepAtCrossing, kClearanceNotMet or
/// kLayersContradict, kCrossingWithoutOrder, kTunnelLowered, kBridgeWithoutGround. Cannot fail. Depends on data within
/// kProfileRadius_m, and farther by two ramps for each storey of bridges or tunnels.
Profiles plan_profiles(const map::FeatureView& features, std::span<const roads::Road> roads,
                       std::span<const roads::Junction> junctions, std::span<const roads::Strip> streams,
                       std::span<const LandCoverPolygon> waters, const map::Heightfield& heights, Report& report,
                       std::span<const Landform> landforms = {});

/// Plans all profiles as plan_profiles() does, on a graph that was made before: that of the features, roads and
/// junctions. The graph's limit_scale may differ from 1.
Profiles plan_profiles_on(const ProfileGraph& graph, const map::FeatureView& features,
                          std::span<const roads::Road> roads, std::span<const roads::Strip> streams,
                          std::span<const LandCoverPolygon> waters, const map::Heightfield& heights, Report& report,
                          std::span<const Landform> landforms = {});

}  // namespace citykiln::ground
