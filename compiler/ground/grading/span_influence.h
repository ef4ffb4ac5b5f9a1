// What bridges and tunnels ask of the land: room below a deck, cover above a bore, and a face in which a mouth is.
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

/// What is free below a deck, and below what slope it is reached from a deck's end.
inline constexpr double kDeckClearance_m = 2.25, kDeckClearanceSlope = 1.5;
/// The land's least thickness over a bore.
inline constexpr double kBoreCover_m = 0.5;
/// Over a bore the slopes of the roads that lead into it start so much higher; in front of it the less.
inline constexpr double kPortal_m = 12, kPortalSlope = 1.5, kPortalSideSlope = 2;

/// How high a bore is from its road to its ceiling: by what goes through.
double bore_height_m(const roads::Road& road);

/// Decks or bores.
struct SpanInfluenceIndex {
  RoadInfluenceIndex field;
  std::vector<double> long_m;    ///< Of each way.
  std::vector<double> height_m;  ///< Bores: from the road to the ceiling.
};
SpanInfluenceIndex index_span_influence(std::span<const roads::Road> spans);

/// The most that the land may be under the decks near a place; infinity where none is. O(segments near).
double max_land_under_decks_m(const SpanInfluenceIndex& decks, Vec2 p);

/// What bores ask of the land at a place.
struct BoreCover {
  double least_m;       ///< Minus infinity where none is near.
  double higher_m = 0;  ///< How much higher the slopes of roads start, if they start below roof_m.
  double roof_m = 0;
};
BoreCover bore_cover_at(const SpanInfluenceIndex& bores, Vec2 p);

/// The height of the ceiling where a line from a to b lies in the mouth of a bore, across it; else minus infinity.
/// @param within_m  How far off the mouth's plane the line may be.
double ceiling_in_mouth_m(const SpanInfluenceIndex& bores, Vec2 a, Vec2 b, double within_m);

}  // namespace citykiln::ground
