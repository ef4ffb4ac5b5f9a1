// Divides building outlines into their parts and the pieces that no part covers, after the tagging scheme Simple 3D
// Buildings.
//
//    outline          parts            built
//    +----------+     +--+    +--+     +--+----+--+
//    |          |     |a |    |b |     |a | p  |b |     p: an uncovered piece of the outline
//    +----------+     +--+    +--+     +--+----+--+
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/map/features.h"

namespace citykiln::map {

/// Marks outlines that parts cover as not built (has_parts), and appends the pieces of them that no part covers. A
/// piece has the outline's tags, height and roof. Footprint::outline of parts and pieces names their outline. Pieces
/// count as split in `account`.
///
/// A part that begins at its outline's eaves or above stands on the outline and covers nothing, and so does one that
/// ends at the outline's lower end or below, such as the steps of a monument. Pieces smaller than
/// kLeastPiece_m2, and strips narrower than kSliver_m, come from imprecise drawing and are left out. The result does
/// not depend on the order of the footprints. Cost: that of overlay() for each outline with parts.
/// @param outlines  part_outlines() of the footprints.
/// @param report    Decides which objects are counted.
std::vector<Footprint> with_uncovered_pieces(std::vector<Footprint> footprints, std::span<const std::uint32_t> outlines,
                                             Account& account, Report& report);

/// The least area of a piece, and the least width of its strips.
inline constexpr double kLeastPiece_m2 = 2, kSliver_m = 0.3;

}  // namespace citykiln::map
