// Cross lines: lines across a road where its segments meet and where its stretches change.
#pragma once

#include <span>
#include <vector>

#include "compiler/roads/generate.h"
#include "compiler/roads/pieces/stretches.h"

namespace citykiln::roads {

/// A line across the axis: the points at + out * offset, offsets to the left positive.
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

/// A bend too sharp for a mitre: both its segments end square and leave a wedge on its outside.
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
/// @param left_m, right_m  The extent of the lines on both sides; at least 0.
/// @param tile_m  Of the plane's grid of tiles. Lines also lie where the road enters and leaves the one-metre margin of
/// a tile border, so that changes beyond them move no edge on the border.
///
/// Guarantees: the two lines of a slice do not cross within their extent; neighbouring slices share their line unless
/// the bend is open. A stretch that would end within a bend ends at its vertex. O(points + stretches).
Slices slices_of(const Road& road, const StripEnds& ends, std::span<const RoadStretch> stretches, double left_m,
                 double right_m, double tile_m);

}  // namespace citykiln::roads
