// Traces the outline of a junction as one ring: for each arm (a road that leaves the junction) out along its right
// edge, across its cut (the line where the junction ends), back along its left edge, and along the corner to the next
// arm.
#pragma once

#include <optional>
#include <span>

#include "compiler/roads/junctions/arm_lines.h"
#include "compiler/roads/junctions/fillet.h"
#include "compiler/roads/junctions/junction.h"

namespace citykiln::roads {

/// The arms of a junction in the forms that its outline needs.
struct JunctionArms {
  std::vector<ArmLine> lines;       ///< Straight line of each arm.
  std::vector<ArmPath> paths;       ///< Axis and widths of each arm near the junction.
  std::vector<std::uint32_t> next;  ///< For each arm the index of the next one counter-clockwise at its node.
  /// Indices of arms counter-clockwise, without roads between two nodes of the junction.
  std::vector<std::uint32_t> order;
  /// For each node the radius of its disk (a turning circle or mini roundabout); 0 if it has none.
  std::vector<double> disks_m;
};
/// Returns the forms of a junction's arms.
/// @param arms  The entry of arms_of() for this junction; parameter of all functions here.
JunctionArms junction_arms(const Junction& junction, std::span<const Road> roads, std::span<const Arm> arms);

/// Returns the outline of a junction of one node without a disk: a simple counter-clockwise ring, snapped, about the
/// node, that covers the union of stroke_pieces(). Nothing if edges do not meet as expected; the caller then computes
/// that union. O(n²) in some thirty points.
std::optional<Ring> trace_outline(const Junction& junction, std::span<const Road> roads, std::span<const Arm> arms,
                                  const JunctionArms& junction_arms);

/// The ring of trace_outline() before it is checked, as floating point gives it. For charts.
std::optional<Ring> trace_outline_unchecked(const Junction& junction, std::span<const Road> roads,
                                            std::span<const Arm> arms, const JunctionArms& junction_arms);

/// Returns rings whose union is the junction: arms up to their cuts, links inside, a disk about each open or circular
/// node, rounded corners. Counter-clockwise, snapped. They are used if trace_outline() fails.
std::vector<Ring> stroke_pieces(const Junction& junction, std::span<const Road> roads, std::span<const Arm> arms,
                                const JunctionArms& junction_arms);

/// Returns the area between two axes and their fillet: the corner and half of either arm. Simple, counter-clockwise,
/// snapped. Nothing if it would cross itself, for example if the arms cross.
std::optional<Ring> corner_ring(const ArmPath& arm, const ArmPath& next, const Fillet& fillet);

/// True if the inner angle at ring[i] is under 14 degrees.
bool is_spike(const Ring& ring, std::size_t i);

/// Appends the points of an arc about `centre` between two unit directions less than half a turn apart, without its
/// ends: 2^halvings - 1 points, snapped.
void add_arc(Vec2 centre, Vec2 from, Vec2 to, double radius_m, int halvings, Ring& ring);

}  // namespace citykiln::roads
