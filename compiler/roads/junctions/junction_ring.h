// The outline of a plain junction, walked around once: right edge out, across the cut, left edge back, corner.
#pragma once

#include <optional>
#include <span>

#include "compiler/roads/junctions/arm_lines.h"
#include "compiler/roads/junctions/fillet.h"
#include "compiler/roads/junctions/junction.h"

namespace citykiln::roads {

/// A junction's arms as lines and as they run, and their order.
struct JunctionArms {
  std::vector<ArmLine> lines;        ///< One an arm.
  std::vector<ArmPath> paths;        ///< One an arm.
  std::vector<std::uint32_t> next;   ///< One an arm: as next_at_place().
  std::vector<std::uint32_t> order;  ///< Counter-clockwise, without the links inside.
  std::vector<double> disks_m;       ///< One a place: its radius where it is round, else 0.
};
JunctionArms junction_arms(const Junction& junction, std::span<const Road> roads, std::span<const Arm> arms);

/// The outline of a junction of one place that is not round, if it can be had so simply: then it is a simple
/// counter-clockwise ring, snapped, about the place, and covers what the union of the junction's pieces covers. Nothing
/// where edges do not meet as they should: the union then decides. O(n²) in points, some thirty.
std::optional<Ring> trace_outline(const Junction& junction, std::span<const Road> roads, std::span<const Arm> arms,
                                  const JunctionArms& junction_arms);

/// The same before it is looked at: what plain floating point makes of it. For charts.
std::optional<Ring> trace_outline_unchecked(const Junction& junction, std::span<const Road> roads,
                                            std::span<const Arm> arms, const JunctionArms& junction_arms);

/// What is united where the walk fails: arms up to their cuts, links inside, a disk about each place, rounded corners.
/// Counter-clockwise rings, snapped.
std::vector<Ring> stroke_pieces(const Junction& junction, std::span<const Road> roads, std::span<const Arm> arms,
                                const JunctionArms& junction_arms);

/// From the first point of the arc to the last, both on kerbs; one point for radius 0. Snapped.
void add_fillet(const Fillet& fillet, Ring& ring);

/// What lies between two axes and the arc from one to the other: the corner, and half of either arm. Simple and
/// counter-clockwise, snapped; nothing where it would cross itself, as about arms that cross.
std::optional<Ring> corner_ring(const ArmPath& arm, const ArmPath& next, const Fillet& fillet);

/// The corner at ring[i] is sharper inside than some 14 degrees.
bool is_spike(const Ring& ring, std::size_t i);

/// Points of an arc about `centre`, from one unit direction to another less than half a turn away, both left out;
/// 2^halvings - 1.
void add_arc(Vec2 centre, Vec2 from, Vec2 to, double radius_m, int halvings, Ring& ring);

}  // namespace citykiln::roads
