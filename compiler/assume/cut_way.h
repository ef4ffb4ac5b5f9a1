// Cuts long ways into stretches of bounded length, so that what is assumed of one does not depend on its other end.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/map/features.h"

namespace citykiln::assume {

/// The map nodes that several tracks share, or one passes twice: sorted.
using CommonNodes = std::vector<std::int64_t>;
CommonNodes common_nodes_of(const std::vector<map::Track>& tracks);

/// Returns a way in pieces, if it is longer than `longest_m`: each is cut at the last common node within `piece_m` of
/// its first point, else at the last node there, else at the next node. Both pieces have the node and its marks. A
/// piece has the way's id with its number as part, from 0 on. The axis does not drift. O(n log n).
std::vector<map::Track> cut_way(const map::Track& way, double longest_m, double piece_m, const CommonNodes& common);

}  // namespace citykiln::assume
