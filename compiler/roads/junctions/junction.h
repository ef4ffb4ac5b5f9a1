// Junctions: roads that meet are cut, and the area between the cuts is the junction. A node is a place where roads
// meet, an arm is a road that leaves a node, a link is the part of a road between two nodes.
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

#include "compiler/contract/findings/report.h"
#include "compiler/geometry/box.h"
#include "compiler/roads/network.h"

namespace citykiln::roads {

/// The largest distance of a cut from the junction's centre along its arm, and the side of the square that contains its
/// nodes. Roads that overlap farther out stay roads. No point of a junction is farther from the centre than this plus
/// three quarters of the width of its widest arm (the tip of a mitre).
inline constexpr double kJunctionRadius_m = 24;

/// The place where an arm is cut, and the radius of one of its corners.
struct Cut {
  /// From the node along the axis; a multiple of 1/4 m. kWholeLink_m: the whole link is inside the junction.
  double length_m = 0;
  double radius_m = 0;  ///< Radius of the corner with the next arm counter-clockwise at its node, links inside
                        ///< included; a multiple of 1/4 m. 0: not rounded.
  bool operator==(const Cut&) const = default;
};
/// The value of Cut::length_m for a link that lies inside the junction as a whole.
inline constexpr double kWholeLink_m = 63.75;

/// A junction: one node, or a few that a driver takes for one. Its arms are not stored: they follow from the roads.
struct Junction {
  Family family{};
  std::vector<Vec2> nodes;  ///< Positions of the nodes, sorted; vertices of axes.
  std::vector<Cut> cuts;    ///< One for each arm, in the order of arms_of().
  bool operator==(const Junction&) const = default;
};

/// Returns the arms of each junction, in the order of its cuts. O(n log n) in vertices.
std::vector<std::vector<Arm>> arms_of(std::span<const Junction> junctions, std::span<const Road> roads);

/// Returns the vertex at which a link inside a junction ends: the next node of the junction, or the end of the road.
/// @param arm    The arm at which the link begins.
/// @param nodes  The junction's nodes, sorted.
std::size_t end_of_link(const Road& road, const Arm& arm, std::span<const Vec2> nodes);

/// Returns the main road of a junction, which gives it its land cover class and id: the one of the highest class, then
/// the widest.
/// @param arms  Not empty.
const Road& main_road(std::span<const Road> roads, std::span<const Arm> arms);

/// Plans all junctions of one network.
///
/// Guarantees: cuts of one road never overlap, unless its whole link is inside; nodes of one junction lie in a square
/// of kJunctionRadius_m; a junction depends on no data farther away than 14 kJunctionRadius_m (three rounds of merging;
/// typically 8). Diagnosed: kRoadInsideJunctions, kJunctionsMerged. Sorted by first arm. Cannot fail. O(n log n).
std::vector<Junction> plan_junctions(std::span<const Road> roads, Report& report);

/// Returns the area of a junction as overlapping counter-clockwise rings, snapped, before other junctions are
/// subtracted. The junction is the union of the rings.
///
/// @param arms  The entry of arms_of() for this junction.
std::vector<Ring> stroke(const Junction& junction, std::span<const Road> roads, std::span<const Arm> arms);

/// Returns a box about the junction's nodes that contains the whole junction.
/// @param widest_arm_m  Width of its widest arm.
Box2 box_of(const Junction& junction, double widest_arm_m);

/// Returns the outlines of all junctions, which share no area: a junction loses the area of junctions of a higher
/// class, or of the same class with a lower first node. Simple outer rings; a junction that others cover completely has
/// none. O(n log n) in junctions.
std::vector<std::vector<Polygon>> outline_junctions(std::span<const Junction> junctions, std::span<const Road> roads,
                                                    int threads);

}  // namespace citykiln::roads
