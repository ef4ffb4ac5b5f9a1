// Pieces: a road as faces of the ground with texture coordinates, u across and v along. A strip is a set of
// neighbouring lanes of one kind (lane_strips.h); a stretch is a part of the road's length with constant markings
// (stretches.h).
//
//      left edge  +-------+---+-----------+      Pieces are strips (lane_strips.h) times stretches (stretches.h) times
//                 |   1   | 2 |     3    / .     segments of the axis. At a bend neighbours meet on its mitre, so that
//           axis  +-------+---+---------+   .    u and v continue from one to the next.
//                 |   4   | 5 |    6   / 7   .
//     right edge  +-------+---+-------+       .
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/roads/generate.h"
#include "compiler/roads/pieces/lane_changes.h"
#include "compiler/roads/pieces/lane_strips.h"
#include "compiler/roads/pieces/stretches.h"

namespace citykiln::roads {

/// One end of a piece: a line across its strip.
struct PieceEnd {
  double left_m = 0, right_m = 0;              ///< Offsets of the strip's edges from the axis, to the left positive.
  double left_along_m = 0, right_along_m = 0;  ///< Distances along the axis, from PieceFrame::at, of the line's ends.
  double v_m = 0;                              ///< v of the line: its distance along the way from RoadStretch::zero_m.
};

/// The position of a piece in its strip, from which uv_at() computes texture coordinates.
struct PieceFrame {
  Vec2 at, along;       ///< A point of the axis and the axis' unit direction there.
  double width_m = 0;   ///< The width without width limits, of the strip or of a part of it (bands of lanes where their
                        ///< number changes).
  double left_u_m = 0;  ///< u at its left edge: not 0 for parts of a strip.
  PieceEnd start, end;
};

/// Returns (u, v) at a point: metres across from the strip's left edge, and metres along the marking layout. Width
/// limits stretch u. v is constant along the start and the end of a piece.
Vec2 uv_at(const PieceFrame& frame, Vec2 p);

inline constexpr std::uint32_t kNoMarkingLayout = 0xffffffffu;

/// The part of one strip in one stretch and one segment of the axis.
struct Piece {
  map::LandCoverClass surface{};
  Ring ring;  ///< Counter-clockwise, snapped.
  PieceFrame frame;
  std::uint32_t layout = kNoMarkingLayout;  ///< Index into RoadPieces::layouts.
  std::uint32_t run = 0;                    ///< Number of its strip and stretch: pieces of one run continue each other.
};

/// A road as pieces.
struct RoadPieces {
  std::vector<Piece> pieces;           ///< Along the road, left to right. They may overlap pieces of other roads.
  std::vector<MarkingLayout> layouts;  ///< Layouts of marked strips.
};

/// Returns the pieces of a road, from its left edge to its right one.
///
/// @param ends         Connections to other roads at both ends.
/// @param stretches    Result of stretches_of() for this road.
/// @param changes      The road's entry of lane_changes_of(); edges of strips lead to those of the next road there.
/// @param tile_m       Side of the tiles.
/// @param tolerance_m  Strips that are narrower than this are merged into a neighbour.
///
/// Guarantees: without changes, the pieces cover stroke_carriageway() and stroke_pavements(), and the verges outside
/// these, except for snapping and for the inside of bends too sharp for a mitre. Neighbours share their corners
/// exactly. At a bend too sharp for a mitre, both segments end square and a joint fills the wedge. O(points · strips).
RoadPieces pieces_of(const Road& road, const StripEnds& ends, std::span<const RoadStretch> stretches,
                     std::span<const LaneChange> changes, double tile_m, double tolerance_m);

}  // namespace citykiln::roads
