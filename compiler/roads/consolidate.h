// Places so close together that a driver takes them for one junction.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/roads/junction_links.h"

namespace citykiln::roads {

/// Which group each node is in: the number of the group's first node.
///
/// Two groups become one where the road between them would be nothing but their corners, and only if each is the
/// other's nearest such neighbour; three rounds, so a group has at most eight nodes and nobody asks farther. A group's
/// places lie within half of kReach_m of their centre. Diagnosed kJunctionsMerged. O(nodes).
std::vector<std::uint32_t> consolidate(std::span<const Road> roads, std::span<const Node> nodes, const NodeIndex& index,
                                       Report& report);

}  // namespace citykiln::roads
