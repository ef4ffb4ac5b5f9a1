// Limits that bridges and tunnels set to the land: clearance below a deck, cover above a bore, a wall at its mouth.
//
//     land ...\____                     ____ land        .-''' land over the bore, never lower than its roof
//     deck =====================================   .-''  |
//              never higher than this below it     road  | mouth: beside the last metres of the road, and over the
//                                                  ======|=====   bore, the road's slopes start higher up
//                                                         bore
#pragma once

#include <span>
#include <vector>

#include "compiler/ground/grading/road_influence.h"

namespace citykiln::ground {

/// The clearance below a deck, and the steepest land that leads down to it from the deck's ends.
inline constexpr double kDeckClearance_m = 2.25, kDeckClearanceSlope = 1.5;
/// The smallest thickness of the land over a bore.
inline constexpr double kBoreCover_m = 0.5;
/// Over a bore the land may be this much higher than the slopes beside the roads that lead into it. In front of the
/// bore and beside it this height decreases at these slopes.
inline constexpr double kPortalWall_m = 12, kPortalWallSlope = 1.5, kPortalWallSideSlope = 2;

/// Returns the height of a bore from its road to its ceiling, which depends on the class of the road or rail.
double bore_height_m(map::LandCoverClass surface);
inline double bore_height_m(const roads::Road& road) { return bore_height_m(road.surface); }

/// An index of decks, or of bores (bored tunnels).
struct SpanInfluenceIndex {
  RoadInfluenceIndex roads;      ///< Their roads.
  std::vector<double> long_m;    ///< Length of each way.
  std::vector<double> height_m;  ///< Result of bore_height_m() for each way.
};
SpanInfluenceIndex index_span_influence(std::span<const roads::Road> spans);

/// Returns the greatest height of the land at p below the decks near it; infinity if there are none. O(segments near).
double max_land_under_decks_m(const SpanInfluenceIndex& decks, Vec2 p);

/// The limits that bores near a place set to the height of the land.
struct BoreCover {
  double least_m;       ///< The smallest height of the land; minus infinity without a bore near.
  double higher_m = 0;  ///< Height by which the slopes beside roads below roof_m start above these roads.
  double roof_m = 0;    ///< Height of the bore's roof, cover included.
};
BoreCover bore_cover_at(const SpanInfluenceIndex& bores, Vec2 p);

/// Returns the height of a bore's ceiling if the line from a to b lies across its mouth; else minus infinity.
/// @param within_m  Largest distance of the line from the mouth's plane.
double ceiling_in_mouth_m(const SpanInfluenceIndex& bores, Vec2 a, Vec2 b, double within_m);

}  // namespace citykiln::ground
