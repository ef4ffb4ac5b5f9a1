// Pieces: a road as faces of the ground in its own coordinates, u across and v along.
//
//      left edge  +-------+---+-----------+      strips (lane_strips.h) times stretches (stretches.h) times the
//                 |   1   | 2 |     3    / .     segments of the axis; at a bend neighbours meet on its mitre, so that
//           axis  +-------+---+---------+   .    u and v go on from one into the next
//                 |   4   | 5 |    6   / 7   .
//     right edge  +-------+---+-------+       .
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/roads/generate.h"
#include "compiler/roads/pieces/lane_strips.h"
#include "compiler/roads/pieces/stretches.h"

namespace citykiln::roads {

/// One end of a piece: a line across its strip.
struct PieceEnd {
  double left_m = 0, right_m = 0;              ///< The strip's edges from the axis, to the left positive.
  double left_along_m = 0, right_along_m = 0;  ///< Where the line meets them, along the axis from PieceFrame::at.
  double v_m = 0;
};

/// Where a piece lies in its strip.
struct PieceFrame {
  Vec2 at, along;      ///< A point of the axis, and the axis' unit direction there.
  double width_m = 0;  ///< Of the strip, where no building narrows it: u at its right edge.
  PieceEnd start, end;
};

/// Metres across from the strip's left edge, and along its pattern; where the strip is narrowed u is stretched. Along
/// the start and the end of a piece v is constant.
Vec2 uv_at(const PieceFrame& frame, Vec2 p);

inline constexpr std::uint32_t kNoMarkingLayout = 0xffffffffu;

struct Piece {
  map::LandCoverClass surface{};
  Ring ring;  ///< Counter-clockwise, snapped.
  PieceFrame frame;
  std::uint32_t layout = kNoMarkingLayout;  ///< One of those of RoadPieces.
  std::uint32_t run = 0;                    ///< The same for neighbours along one strip and stretch.
};

struct RoadPieces {
  std::vector<Piece> pieces;  ///< Along the road, from left to right; what lies over what is for others to say.
  std::vector<MarkingLayout> layouts;  ///< Of strips that are marked.
};

/// All of a road from its left edge to its right one.
///
/// Guarantees: pieces cover what stroke_carriageway() and stroke_pavements() cover, and the verges outside of it, but
/// for snapping and for the inside of bends too sharp for a mitre; neighbours share their corners exactly; no case
/// fails: where a mitre does not fit, both segments end square and a joint fills the wedge. O(points · strips).
RoadPieces pieces_of(const Road& road, const StripEnds& ends, std::span<const RoadStretch> stretches, double tile_m,
                     double tolerance_m);

}  // namespace citykiln::roads
