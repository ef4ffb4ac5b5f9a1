// Rights-of-way: the outlines of streets and other lines, and their edges as chains.
//
//      │ │         each axis segment has a right-of-way; where two arms of a node enclose
//   ───┘ └───      less than half a turn, their edges are cut at their crossing,
//   ───┐ ┌───      else a joint fills the gap between them
//      │ │
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/parcels/parcels.h"

namespace citykiln::parcels {

/// No index.
inline constexpr std::uint32_t kNoIndex = 0xffffffffu;

/// An edge of a street's right-of-way, directed so that the land lies to its left.
struct RightOfWayEdge {
  std::uint32_t line = 0, segment = 0;
  Side side = Side::kLeft;
  Vec2 a, b;    ///< Cut where the next right-of-way begins, so it may have no length.
  Vec2 normal;  ///< Towards the land, length 1.
  /// The edge that follows this one along the same land, around a corner or dead end too.
  std::uint32_t next = kNoIndex;
  std::uint32_t previous = kNoIndex;
  bool turns_outward = false;  ///< True if the next one turns away from the land, as at a dead end.
  bool is_corner = false;      ///< True if the next one turns towards the land by more than 40°.
  std::uint8_t size = 0;       ///< Index into Land::sizes.
  double length_m() const { return distance(a, b); }
};

/// A polygon of rights-of-way, counter-clockwise and convex up to the rounding of its points.
struct RightOfWayPiece {
  Ring ring;
  std::vector<Border> borders;  ///< One for each edge; kInner for edges inside rights-of-way.
};

struct RightsOfWay {
  /// First those of axis segments in the order of lines, then those of round ends.
  std::vector<RightOfWayEdge> street_edges;
  std::vector<RightOfWayPiece> pieces;
};

/// Returns the rights-of-way of lines. Widths are limited from below by kLeastRightOfWay_m.
/// @param lines  Sorted by id. Lines of LineKind::kNone and axes of fewer than two different points have no
/// right-of-way. Cost: O(n log n).
RightsOfWay rights_of_way_of(const std::vector<Line>& lines);

}  // namespace citykiln::parcels
