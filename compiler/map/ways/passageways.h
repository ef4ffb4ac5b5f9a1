// Decides where ways lead through buildings on the ground, from the map alone, before roads and buildings are planned.
//
//      ________      ________
//     |        |    |        |     the axis of a passageway is the part of the way inside the footprint, extended
//     | - - - -|-- -| - - - -|--   until both sides of the opening are outside the walls
//     |________|    |________|
#pragma once

#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/map/features.h"

namespace citykiln::map {

/// Returns the tracks. A tunnel becomes a covered way on the ground if it leads through buildings and nothing else: a
/// road or path without a tagged layer, at least kInsideShare of it inside footprints, both ends within kEndAtWall_m of
/// a wall, and not longer than kLongestPassage_m. O(n) in points of tunnels.
std::vector<Track> with_passages_on_ground(std::vector<Track> tracks, const std::vector<Footprint>& footprints);

/// For such a tunnel: the least share of its length inside footprints, the largest distance of its ends from a wall,
/// and its greatest length.
inline constexpr double kInsideShare = 0.75, kEndAtWall_m = 4, kLongestPassage_m = 120;

/// Returns the passageways of all buildings, sorted by building, then by way.
///
/// - A way that is tagged as covered (building_passage, covered=*, arcade=*) has one wherever it runs inside a
///   building.
/// - Another way on the ground has one where it crosses a building from side to side and the building goes on beside it
///   (diagnosed as kPassageAssumed). A way that ends inside a building or cuts a corner has none.
/// - Open roofs, outlines that parts replace, buildings that begin kLeastPath_m or more above the ground, and indoor
///   ways have none.
///
/// An arcade is open on its outer side. It is a covered way beside a wall that is at most 3 m from its edge (1 m unless
/// it is tagged as an arcade), with no building beyond the wall.
///
/// A passageway is as wide as the way with its pavements, or as the carriageway where the building has no room for
/// them. It depends on one way, one footprint, and whether other ways continue at the way's ends; arcades also on the
/// buildings beside them. O(n log n).
/// @param features  With the tracks' final widths.
std::vector<Passageway> plan_passageways(const FeatureView& features, Report& report);

/// The height of an opening for a way without a tagged height: over roads, paths and rails.
inline constexpr double kRoadClearance_m = 4, kPathClearance_m = 3.5, kRailClearance_m = 5.5;
/// The least height in which a way can be used: roads, paths and rails.
inline constexpr double kLeastRoad_m = 3.5, kLeastPath_m = 2, kLeastRail_m = 4.5;

}  // namespace citykiln::map
