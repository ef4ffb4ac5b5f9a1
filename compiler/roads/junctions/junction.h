// Junctions: where roads meet, each is cut, and what lies between the cuts is the junction.
//
//        |  |                  1. every arm is a strip as wide as its road
//     ___|  |___               2. neighbouring strips meet in a corner, left edge with right edge; the corner is
//     rounded
//     ___)  (___               3. an arm is cut square where the farther of its two corners ends
//        |  |                  4. the strips up to the cuts, and the corners, are the junction: their union, whatever
//        it is
//
// See junctions.md for why no step can fail.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/geometry/box.h"
#include "compiler/roads/network.h"

namespace citykiln::roads {

/// No cut lies farther from a junction's centre, along its arm, than this: farther apart, roads are roads, even side by
/// side. No point of a junction lies farther from the centre than this and three quarters of its widest arm (the tip of
/// a bend's mitre).
inline constexpr double kJunctionRadius_m = 24;

/// What is decided about an arm.
struct Cut {
  double length_m = 0;  ///< Along the axis, from the arm's place; a multiple of 1/4 m. kWholeLink_m: a link
                        ///< inside the junction.
  double radius_m = 0;  ///< Of the corner with the next arm of its place, counter-clockwise, links inside among them; a
                        ///< multiple of 1/4 m; 0: not rounded.
  bool operator==(const Cut&) const = default;
};
inline constexpr double kWholeLink_m = 63.75;

/// A junction: one place, or a few that a driver takes for one. Its roads say the rest.
struct Junction {
  Family family{};
  std::vector<Vec2> places;  ///< Sorted; vertices of axes.
  std::vector<Cut> cuts;     ///< One an arm, in the order of arms_at().
  bool operator==(const Junction&) const = default;
};

/// Which arms each junction has, in the order of its cuts. O(n log n) in vertices.
std::vector<std::vector<Arm>> arms_of(std::span<const Junction> junctions, std::span<const Road> roads);

/// The road that gives a junction its surface and its name: the one of highest class, then the widest.
const Road& main_road(std::span<const Road> roads, std::span<const Arm> arms);

/// Decides all junctions of a layer's roads.
///
/// Guarantees: cuts of one road never overlap, unless its whole link is inside; places of one junction lie in a
/// square of kJunctionRadius_m; what is decided depends on nothing farther than 14 kJunctionRadius_m away (three rounds
/// of merging; 8 as a rule). Diagnosed: kRoadInsideJunctions (a road between two junctions that nothing is left of),
/// kJunctionsMerged. Sorted by their first arm. Total. O(n log n).
std::vector<Junction> plan_junctions(std::span<const Road> roads, Report& report);

/// The junction as overlapping counter-clockwise rings, snapped; their union is what it covers, before higher junctions
/// are taken off.
///
/// @param arms  arms_at(roads, junction.places, junction.family).
std::vector<Ring> stroke(const Junction& junction, std::span<const Road> roads, std::span<const Arm> arms);

/// No point of a junction lies outside of this box about its places.
Box2 box_of(const Junction& junction, double widest_arm_m);

/// Outlines that share no area: every junction without what those of a higher class, or of the same class and an
/// earlier place, cover. Simple rings. Empty for a junction that others cover whole. O(n log n) in junctions.
std::vector<std::vector<Polygon>> outline(std::span<const Junction> junctions, std::span<const Road> roads,
                                          int threads);

}  // namespace citykiln::roads
