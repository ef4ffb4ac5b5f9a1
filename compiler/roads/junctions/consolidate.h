// Merges nodes that a driver takes for one junction. A node is a place where roads meet; a link is the part of a road
// from one node to the next; an arm is a road that leaves a node.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/roads/junctions/junction_links.h"

namespace citykiln::roads {

/// Returns the group of each node, as the index of the group's first node.
///
/// Two nodes merge if a link between them
/// - has no length left between their corners;
/// - joins two street junctions and has less than a car's length left;
/// - crosses the median of a dual carriageway, and is no longer than one and a half times the wider carriageway;
/// - encloses an island with a second link between the same nodes. Street junctions have three arms of residential or
/// higher class. Driveways, car parks, paths, roundabout rings and circular nodes merge by the first rule only.
///
/// Each of three rounds merges the pairs of groups that are each other's nearest, so a group has at most eight nodes
/// and its content depends on a bounded neighbourhood. A group fits into a square of kJunctionRadius_m. Diagnosed:
/// kJunctionsMerged. O(nodes).
std::vector<std::uint32_t> consolidate(std::span<const Road> roads, std::span<const Node> nodes, const NodeIndex& index,
                                       Report& report);

}  // namespace citykiln::roads
