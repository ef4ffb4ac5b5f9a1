// Cross lines: lines across a road at the bends of its axis and at the ends of its stretches.
#pragma once

#include <span>
#include <vector>

#include "compiler/roads/generate.h"
#include "compiler/roads/pieces/stretches.h"

namespace citykiln::roads {

/// A line across the axis: the points at + out * offset, where offsets to the left are positive.
struct CrossLine {
  Vec2 at, out;
  double along_m = 0;  ///< The distance of `at` along the way.
};

/// The part of a segment between two cross lines, within one stretch.
struct Slice {
  Vec2 along;  ///< The segment's unit direction.
  CrossLine start, end;
  std::uint32_t stretch = 0;
};

/// A bend too sharp for a mitre: both segments end square and leave a wedge on the outside of the bend.
struct OpenBend {
  Vec2 at, before, after;   ///< The point, and the directions of its segments.
  std::uint32_t slice = 0;  ///< The slice that ends there; at the road's first point, the one that begins there.
};

struct Slices {
  std::vector<Slice> slices;
  std::vector<OpenBend> bends;  ///< Sorted along the road.
};

/// Cuts a road into slices.
///
/// @param left_m, right_m  The lengths of the lines on both sides; at least 0.
/// @param tile_m           Side of the tiles. The road is also cut where it enters and leaves a margin of one metre
///                         about a tile border, so that changes beyond the margin move no edge on the border.
///
/// Guarantees: the two lines of a slice do not cross; neighbouring slices share their line unless the bend is open. A
/// stretch that would end within a bend ends at the bend's vertex. O(points + stretches).
Slices slices_of(const Road& road, const StripEnds& ends, std::span<const RoadStretch> stretches, double left_m,
                 double right_m, double tile_m);

}  // namespace citykiln::roads
