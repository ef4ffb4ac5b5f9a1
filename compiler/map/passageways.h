// Decides where ways lead through buildings on the ground: once, in plan, before roads and buildings are planned.
//
//      ________      ________
//     |        |    |        |     the axis of a passageway is the part of the way inside the footprint, continued
//     | - - - -|-- -| - - - -|--   until both sides of the opening are outside its walls
//     |________|    |________|
#pragma once

#include <vector>

#include "compiler/contract/report.h"
#include "compiler/map/features.h"

namespace citykiln::map {

/// Returns the tracks with those tunnels on the ground that only lead through buildings: tunnel=yes without a layer, at
/// least kInsideShare of it inside footprints, both ends at their walls, and not longer than kLongestPassage_m. They
/// become covered ways. O(n) in points of tunnels.
std::vector<Track> with_passages_on_ground(std::vector<Track> tracks, const std::vector<Footprint>& footprints);

/// The share of a tunnel inside footprints, the largest distance of its ends from their walls, and its length.
inline constexpr double kInsideShare = 0.75, kEndAtWall_m = 4, kLongestPassage_m = 120;

/// Returns the passageways of all buildings, sorted by building, then by way.
///
/// - Ways tagged to be covered (building_passage, covered=*, arcade=*) have one wherever they run inside a building.
/// - Other ways on the ground have one where they cross a building from one side to the other, so that parts of it
///   remain on both sides (kPassageAssumed); ways that end inside a building or cut a corner have none.
/// - Open roofs, outlines that parts replace, parts that begin above the way's headroom, and indoor ways have none.
///
/// An arcade is open on its outer side: a covered way along a wall at most 3 m from its edge (1 m unless tagged as an
/// arcade), where nothing is built beyond the wall.
///
/// A passageway is as wide as the way with its pavements; without them where the building has no room for them. It
/// depends on one way and one footprint, and on whether other ways continue at the way's ends. O(n log n).
/// @param features  With the tracks' final widths.
std::vector<Passageway> plan_passageways(const Features& features, Report& report);

/// The height of an opening without a tag: over roads, paths and rails.
inline constexpr double kRoadClearance_m = 4, kPathClearance_m = 3.5, kRailClearance_m = 5.5;
/// The clearance that a car, a person and a train need.
inline constexpr double kLeastRoad_m = 3.5, kLeastPath_m = 2, kLeastRail_m = 4.5;

}  // namespace citykiln::map
