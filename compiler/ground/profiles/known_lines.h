// Selects the stretches of roads and rails that lie on the land, so that their heights correct the heightmap.
#pragma once

#include <span>
#include <vector>

#include "compiler/ground/correction/known_line.h"
#include "compiler/ground/landforms/landform_index.h"
#include "compiler/ground/profiles/graph/profile_graph.h"
#include "compiler/map/plane/heightfield.h"

namespace citykiln::ground {

/// The distance along roads from the end of a tunnel within which they lie in its cutting.
inline constexpr double kPortalCutting_m = 64;
/// A road that crossings move by more than this is on a ramp, above or below the land.
inline constexpr double kLeastRamp_m = 0.5;

/// Returns the pieces between stations of ways on the ground, in the order of ways, without those before tunnels
/// (kPortalCutting_m) and with cutting=* or embankment=*: there the road is not on the land. Heights are those of the
/// road, on ramps to crossings (kLeastRamp_m) those that it would have without the crossing, less the changes that
/// landforms make there. Runways are KnownKind::kLevel.
///
/// @param ground_m  Heights by node before crossings move lines.
/// @param z_m       Planned heights by node.
std::vector<KnownLine> known_lines(const ProfileGraph& graph, std::span<const double> ground_m,
                                   std::span<const double> z_m, const map::Heightfield& heights,
                                   const LandformIndex& landforms);

}  // namespace citykiln::ground
