// Straight lines that approximate arms (roads that leave a junction) near the junction, for bearings, corners and
// overlaps.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "compiler/roads/network.h"

namespace citykiln::roads {

/// An arm as a straight line.
struct ArmLine {
  Vec2 from, along;                ///< The node, plane metres, and a unit vector.
  double left_m = 0, right_m = 0;  ///< Distances to the kerbs, seen along the arm.
};

/// Returns the line from the arm's node towards the point 8 m along the arm, or towards its end if the arm is shorter,
/// so that an imprecise first metre does not turn it.
ArmLine arm_line(std::span<const Road> roads, const Arm& arm);

/// Returns the lines of several arms.
std::vector<ArmLine> arm_lines(std::span<const Road> roads, std::span<const Arm> arms);

/// Returns the indices of arms counter-clockwise about a centre, beginning at east. Arms are compared by the points of
/// their lines 8 m from their nodes, also if they are shorter; equal ones stay in order.
std::vector<std::uint32_t> counter_clockwise(std::span<const ArmLine> lines, Vec2 centre);

/// Returns for each arm the index of the next one counter-clockwise at its node; its own if it is the only one.
///
/// @param lines  The lines of all arms. Lines of one node (equal `from`) must be neighbours in the list.
std::vector<std::uint32_t> next_at_node(std::span<const ArmLine> lines);

/// The intersection of the left edge of an arm with the right edge of the next arm counter-clockwise.
struct Corner {
  double along_arm_m = 0, along_next_m = 0;  ///< Distances along the arms from their nodes; at least 0.
  double sine = 1;                           ///< Sine of the angle between the arms.
};

/// Returns the corner between two arms; nothing if the angle between them is over 160 degrees, as such a corner needs
/// neither rounding nor a cut. Both lengths are infinite if the arms run side by side and overlap.
std::optional<Corner> corner_between(const ArmLine& arm, const ArmLine& next);

}  // namespace citykiln::roads
