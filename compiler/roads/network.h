// The road network: nodes, the places that axes of several roads share, and arms, the roads that leave a node.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "compiler/roads/generate.h"
#include "compiler/roads/recipe.h"

namespace citykiln::roads {

using map::Family;
using map::family_of;

/// True for streets of residential or higher class; false for driveways, car parks and tracks.
bool is_through_street(const Road& road);

/// A road leaving a node, from axis[vertex] towards axis[vertex + step].
struct Arm {
  std::uint32_t road = 0, vertex = 0;
  std::int32_t step = 1;  ///< 1 or -1.
  auto operator<=>(const Arm&) const = default;
};

/// A position on the plane's grid where axes of one family meet or end.
struct Node {
  Vec2 at;
  Family family{};
  std::vector<Arm> arms;  ///< Sorted.
};

/// The radius of a turning loop's island, and the width of the lane around it.
inline constexpr double kLoopIsland_m = 3.5, kLoopLane_m = 5;

/// Returns the radius of the disk of ground about the node of these arms: 5 m for a mini roundabout, 6 m for a turning
/// circle, 8.5 m for a turning loop (track points of the roads), but at least 1.5 m more than the largest distance from
/// an arm's axis to its kerb, and at most 12 m. 0 if the node is none of these. O(track points of the arms' roads).
double disk_radius_m(std::span<const Road> roads, std::span<const Arm> arms);

/// Returns the nodes at which a junction may be needed: with at least three arms, with two arms that do not continue
/// each other (their widths differ, or the turn is more than a right angle), or with a disk (disk_radius_m()).
///
/// Axes meet only if they share a vertex, so a bridge does not meet the road below it. Sorted by position, then family.
/// O(n log n) in vertices.
std::vector<Node> find_nodes(std::span<const Road> roads);

/// Returns the ends of each road. An end is joined if exactly one other end of a road of its family lies there. O(n log
/// n) in vertices.
std::vector<StripEnds> ends_of(std::span<const Road> roads);

/// Two arms that continue each other at a place without a third arm. They belong to two roads, or are both ends of a
/// loop.
struct Joint {
  Arm a, b;
};
/// Returns all joints, sorted by position. O(n log n) in vertices.
std::vector<Joint> joints_of(std::span<const Road> roads);

/// The distance from an arm's axis to its left or right kerb, as seen when leaving the node.
double arm_left_m(std::span<const Road> roads, const Arm& arm);
double arm_right_m(std::span<const Road> roads, const Arm& arm);

/// Appends the arms that leave a vertex of a road: two, or one at its ends.
void append_arms(std::span<const Road> roads, std::uint32_t road, std::uint32_t vertex, std::vector<Arm>& arms);

/// True if the road of an arm has traffic signals at the arms' node.
bool has_signals(std::span<const Road> roads, std::span<const Arm> arms);

/// Returns the first part of an arm's axis, at most `length_m` long. The last point may be interpolated and is not
/// snapped. At least two points if length_m > 0.
Polyline arm_axis(std::span<const Road> roads, const Arm& arm, double length_m);

}  // namespace citykiln::roads
