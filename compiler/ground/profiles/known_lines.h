// Selects the stretches of roads and rails that lie on the land. Their heights then correct the
// heightmap (corrected_land.h).
#pragma once

#include <span>
#include <vector>

#include "compiler/ground/correction/known_line.h"
#include "compiler/ground/landforms/landform_index.h"
#include "compiler/ground/profiles/graph/profile_graph.h"
#include "compiler/map/plane/heightfield.h"

namespace citykiln::ground {

/// The distance in metres, along roads, from the end of a tunnel within which a road lies in a
/// cutting.
inline constexpr double kPortalCutting_m = 64;
/// The change of height by crossings, in metres, above which a node of a road is on a ramp, above
/// or below the land.
inline constexpr double kLeastRamp_m = 0.5;

/// Returns one line for each two neighbouring stations of ways on the ground, in the order of ways.
/// Lines within kPortalCutting_m of tunnels, and of ways with cutting=* or embankment=*, are left
/// out, since they are not on the land. Runways are KnownKind::kLevel, all others KnownKind::kRoad.
///
/// Heights are the planned ones. Nodes on ramps (kLeastRamp_m) have their heights before crossings
/// moved them. The change that landforms make at the node is subtracted, since landforms are
/// applied to the corrected land again. O(stations).
///
/// @param ground_m  Heights by node, in metres, before crossings move them.
/// @param z_m       Planned heights by node, in metres.
/// @param heights   The terrain without landforms.
std::vector<KnownLine> known_lines(const ProfileGraph& graph, std::span<const double> ground_m,
                                   std::span<const double> z_m, const map::Heightfield& heights,
                                   const LandformIndex& landforms);

}  // namespace citykiln::ground
