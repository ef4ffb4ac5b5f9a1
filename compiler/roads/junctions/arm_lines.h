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
  Vec2 from, along;                ///< `along` is a unit vector.
  double left_m = 0, right_m = 0;  ///< Distances to the kerbs, seen along the arm.
};

/// Returns the line from the arm's node to the point 8 m along it, so that an imprecise first metre does not turn it.
ArmLine arm_line(std::span<const Road> roads, const Arm& arm);

/// Returns the lines of several arms.
std::vector<ArmLine> arm_lines(std::span<const Road> roads, std::span<const Arm> arms);

/// Returns the indices of arms counter-clockwise about a centre, by the points of the arms 8 m from their nodes.
std::vector<std::uint32_t> counter_clockwise(std::span<const ArmLine> lines, Vec2 centre);

/// Returns for each arm the next one counter-clockwise at its node; the arm itself if it is the only one.
///
/// @param lines  The lines of all arms, grouped by node.
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
