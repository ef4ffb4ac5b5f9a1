// Divides building outlines into their parts and what no part covers, as Simple 3D Buildings says it.
//
//    outline          parts            built
//    +----------+     +--+    +--+     +--+----+--+
//    |          |     |a |    |b |     |a | -1 |b |
//    +----------+     +--+    +--+     +--+----+--+
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/map/features.h"

namespace citykiln::map {

/// Marks outlines that have parts as not built (has_parts), and adds the pieces of them that no part covers. A piece
/// has the outline's tags, and with them its height and roof; the outline is its `outline`. Pieces are counted as
/// split.
///
/// A part that begins at its outline's eaves or above stands on it and covers nothing. Pieces smaller than
/// kLeastPiece_m2, and strips narrower than kSliver_m, are imprecision of the drawing and left out. The result does not
/// depend on the order of the footprints. Cost: overlay()'s for each outline with parts.
/// @param outlines  part_outlines() of the footprints.
std::vector<Footprint> with_uncovered_pieces(std::vector<Footprint> footprints, std::span<const std::uint32_t> outlines,
                                             Account& account, Report& report);

/// The least area of a piece, and the least width of its strips.
inline constexpr double kLeastPiece_m2 = 2, kSliver_m = 0.3;

/// The number by which ObjectId::part of an outline's pieces grows from one piece to the next.
inline constexpr std::uint32_t kPieceStride = 1u << 16;

}  // namespace citykiln::map
