// Lowers the mouths of tunnels in flat land, with the lines that lead to them, until the land covers the tunnel. So a
// line goes down into the ground in a cutting, and no mound has to cover it.
//
//     land ──────.                 ┌────────── land over the bore
//                 `·.   cutting    │ mouth
//      approach      `·.___________│═════════ bore
//
// The approach keeps its grade limit and the heights of its junctions. Where it is too short the mouth lies as deep as
// it can.
#pragma once

#include <span>
#include <vector>

#include "compiler/ground/profiles/graph/profile_graph.h"
#include "compiler/map/features.h"
#include "compiler/map/plane/heightfield.h"

namespace citykiln::ground {

/// The least share of its grade limit at which an approach leads down: paths other than steps are flatter where there
/// is room, at 12 %.
inline constexpr double kPathRampShare = 0.24;
/// Shallower mouths by up to this are deep enough.
inline constexpr double kLeastDescent_m = 0.125;

/// True if the land should cover a tunnel: not a corridor in a building, nor a tunnel tagged to lie above the ground.
bool needs_cover(const map::Track& tunnel);

/// Returns heights by node in which mouths are lowered.
///
/// @param features  The map: paths that cross an approach at a common node keep it on the land there.
/// @param heights   The terrain.
/// @param z_m       Heights by node.
///
/// Guarantees: no node rises, pinned nodes and junctions of three arms and more stay, and lines within their grade
/// limits stay within them. A mouth is lowered at most by the bore's height and cover, and not at all where the land
/// kPortalLength_m behind it covers the bore, or where a tunnel of layer 0 is so short that it may be a passage through
/// a building (map::kLongestPassage_m). Cannot fail. O(n log n) in the nodes of cuttings, plus O(n) in the
/// graph.
std::vector<double> lower_mouths(const ProfileGraph& graph, const map::FeatureView& features,
                                 const map::Heightfield& heights, std::span<const double> z_m);

}  // namespace citykiln::ground
