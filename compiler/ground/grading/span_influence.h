// What bridges and tunnels require of the land: clearance below a deck, cover above a bore, and a wall for its mouth.
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
/// The land's least thickness over a bore.
inline constexpr double kBoreCover_m = 0.5;
/// Over a bore the land may be this much higher than the slopes beside the roads that lead into it; in front of the
/// bore and beside it by less, at these slopes.
inline constexpr double kPortal_m = 12, kPortalSlope = 1.5, kPortalSideSlope = 2;

/// Returns the height of a bore from its road to its ceiling, by what passes through.
double bore_height_m(const roads::Road& road);

/// Decks or bores.
struct SpanInfluenceIndex {
  RoadInfluenceIndex field;
  std::vector<double> long_m;    ///< Length of each way.
  std::vector<double> height_m;  ///< Of bores: from the road to the ceiling.
};
SpanInfluenceIndex index_span_influence(std::span<const roads::Road> spans);

/// Returns the greatest height that decks near p leave the land; infinity where there are none. O(segments near).
double max_land_under_decks_m(const SpanInfluenceIndex& decks, Vec2 p);

/// What bores near a place require of the land.
struct BoreCover {
  double least_m;       ///< The least height; minus infinity without a bore near.
  double higher_m = 0;  ///< How much higher the slopes beside roads start, for roads below roof_m.
  double roof_m = 0;
};
BoreCover bore_cover_at(const SpanInfluenceIndex& bores, Vec2 p);

/// Returns the height of the ceiling where a line from a to b lies across the mouth of a bore; else minus infinity.
/// @param within_m  Largest distance of the line from the mouth's plane.
double ceiling_in_mouth_m(const SpanInfluenceIndex& bores, Vec2 a, Vec2 b, double within_m);

}  // namespace citykiln::ground
