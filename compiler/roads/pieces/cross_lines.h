// Cross lines: lines across a road at the bends of its axis and at the ends of its stretches (parts with constant
// markings, stretches.h). They cut the road into slices.
#pragma once

#include <span>
#include <vector>

#include "compiler/roads/generate.h"
#include "compiler/roads/pieces/lane_changes.h"
#include "compiler/roads/pieces/stretches.h"

namespace citykiln::roads {

/// A line across the axis: the points at + out * offset, where offsets to the left are positive.
struct CrossLine {
  Vec2 at, out;
  double along_m = 0;  ///< The distance of `at` along the way.
};

/// The part of a road between two cross lines. It lies in one segment of the axis and in one stretch.
struct Slice {
  Vec2 along;  ///< The segment's unit direction.
  CrossLine start, end;
  std::uint32_t stretch = 0;  ///< Index of the stretch.
};

/// A bend too sharp for a mitre. The segments on both sides end square, which leaves a wedge on the outside of the
/// bend.
struct OpenBend {
  Vec2 at, before, after;   ///< The point, and the directions of its segments.
  std::uint32_t slice = 0;  ///< The slice that ends there; at the road's first point, the one that begins there.
};

/// A road cut into slices.
struct Slices {
  std::vector<Slice> slices;
  std::vector<OpenBend> bends;  ///< Sorted along the road.
};

/// Cuts a road into slices.
///
/// @param left_m, right_m  The lengths of cross lines on both sides of the axis; at least 0.
/// @param changes          The road's entry of lane_changes_of(): where edges bend and reach farther out.
/// @param tile_m           Side of the tiles. The road is also cut one metre before and after a tile border, so that
///                         changes farther away move no edge on the border.
///
/// Guarantees: the two lines of a slice do not cross; neighbouring slices share their line unless the bend is open. A
/// stretch that would end within a bend ends at the bend's vertex. O(points · (stretches + bends of the
/// edges)).
Slices slices_of(const Road& road, const StripEnds& ends, std::span<const RoadStretch> stretches, double left_m,
                 double right_m, std::span<const LaneChange> changes, double tile_m);

}  // namespace citykiln::roads
