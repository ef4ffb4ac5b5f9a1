// Merges nodes that a driver takes for one junction.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/roads/junctions/junction_links.h"

namespace citykiln::roads {

/// Returns the group of each node, named by the group's first node.
///
/// A link merges two nodes
/// - where nothing is left of it between their corners;
/// - between street junctions, where less than a car's length is left;
/// - where it crosses the median of a dual carriageway no wider than one and a half of the wider carriageway;
/// - where a second link between the same nodes makes an island.
/// Street junctions have three arms of residential or higher class. Driveways, car parks, paths, roundabout rings and
/// circular nodes merge by the first rule alone.
///
/// Each of three rounds merges the pairs of groups that are each other's nearest, so a group has at most eight nodes
/// and its content depends on a bounded neighbourhood. A group fits into a square of kJunctionRadius_m. Diagnosed:
/// kJunctionsMerged. O(nodes).
std::vector<std::uint32_t> consolidate(std::span<const Road> roads, std::span<const Node> nodes, const NodeIndex& index,
                                       Report& report);

}  // namespace citykiln::roads
