// Places so close together that a driver takes them for one junction.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/roads/junctions/junction_links.h"

namespace citykiln::roads {

/// Which group each node is in: the number of the group's first node.
///
/// A link makes two nodes one junction
///   where nothing is between their corners;
///   between streets, where less than a car's length is;
///   from one carriageway of a road to the other, where the median is no wider than one and a half of the wider
///   carriageway; round an island, where two links join the same two nodes.
/// Streets are residential ones and higher, and their nodes have three of them: driveways and car parks merge by the
/// first rule only, as do paths, rings of roundabouts and round places. Two groups become one only if each is the
/// other's nearest such neighbour; three rounds, so a group has at most eight nodes and nobody asks farther. A
/// group's places lie in a square of kJunctionRadius_m. Diagnosed kJunctionsMerged. O(nodes).
std::vector<std::uint32_t> consolidate(std::span<const Road> roads, std::span<const Node> nodes, const NodeIndex& index,
                                       Report& report);

}  // namespace citykiln::roads
