// Junctions: where roads meet, each is cut, and the area between the cuts is the junction.
//
//        |  |        1. every arm is a strip as wide as its road
//     ___|  |___     2. neighbouring strips meet in a corner, left edge with right edge; the corner is rounded
//     ___)  (___     3. an arm is cut square to its axis behind the farther of its two corners
//        |  |        4. the union of the strips up to the cuts and of the corners is the junction
//
// junctions.md explains why no step can fail.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/geometry/box.h"
#include "compiler/roads/network.h"

namespace citykiln::roads {

/// The maximum distance of a cut from the junction's centre along its arm, and the side of the square that holds its
/// nodes. Roads that overlap farther out stay roads. No point of a junction lies farther from the centre than this and
/// three quarters of its widest arm (the tip of a mitre).
inline constexpr double kJunctionRadius_m = 24;

/// What is decided about an arm.
struct Cut {
  double length_m =
      0;  ///< From the node along the axis; a multiple of 1/4 m. kWholeLink_m: the whole link is inside the junction.
  double radius_m = 0;  ///< Of the corner with the next arm of its node counter-clockwise, links inside included; a
                        ///< multiple of 1/4 m. 0: not rounded.
  bool operator==(const Cut&) const = default;
};
inline constexpr double kWholeLink_m = 63.75;

/// A junction: one node, or a few that a driver takes for one. Its arms follow from the roads.
struct Junction {
  Family family{};
  std::vector<Vec2> nodes;  ///< Their positions, sorted; vertices of axes.
  std::vector<Cut> cuts;    ///< One for each arm, in the order of arms_of().
  bool operator==(const Junction&) const = default;
};

/// Returns the arms of each junction, in the order of its cuts. O(n log n) in vertices.
std::vector<std::vector<Arm>> arms_of(std::span<const Junction> junctions, std::span<const Road> roads);

/// Returns the vertex at which an arm whose whole link is inside a junction ends: at the junction's next node, or at
/// the end of the road. @param nodes  Sorted.
std::size_t end_of_link(const Road& road, const Arm& arm, std::span<const Vec2> nodes);

/// Returns the road of highest class, then width: it gives the junction its land cover class and its id. @param arms
/// Not empty.
const Road& main_road(std::span<const Road> roads, std::span<const Arm> arms);

/// Plans all junctions of one network.
///
/// Guarantees: cuts of one road never overlap, unless its whole link is inside; nodes of one junction lie in a square
/// of kJunctionRadius_m; a decision depends on nothing farther than 14 kJunctionRadius_m away (three rounds of merging;
/// typically 8). Diagnosed: kRoadInsideJunctions, kJunctionsMerged. Sorted by first arm. Total. O(n log n).
std::vector<Junction> plan_junctions(std::span<const Road> roads, Report& report);

/// Returns the junction as overlapping counter-clockwise rings, snapped. Their union is its area before higher
/// junctions are subtracted.
///
/// @param arms  arms_of() for this junction.
std::vector<Ring> stroke(const Junction& junction, std::span<const Road> roads, std::span<const Arm> arms);

/// Returns a box about the junction's nodes that holds the whole junction.
Box2 box_of(const Junction& junction, double widest_arm_m);

/// Returns outlines that share no area: every junction without what junctions of a higher class, or of the same class
/// and a lower first node, cover. Simple outer rings; a junction that others cover completely has none. O(n log n) in
/// junctions.
std::vector<std::vector<Polygon>> outline_junctions(std::span<const Junction> junctions, std::span<const Road> roads,
                                                    int threads);

}  // namespace citykiln::roads
