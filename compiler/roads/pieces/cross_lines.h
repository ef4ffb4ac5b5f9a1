// Lines across a road: where its segments meet and where its stretches change.
#pragma once

#include <span>
#include <vector>

#include "compiler/roads/generate.h"
#include "compiler/roads/pieces/stretches.h"

namespace citykiln::roads {

/// A line across the axis: the points at + out * offset, the offset to the left positive.
struct CrossLine {
  Vec2 at, out;
  double along_m = 0;  ///< Of `at`, along the way.
};

/// A part of a segment of the axis between two lines across it, all in one stretch.
struct Slice {
  Vec2 along;  ///< The segment's unit direction.
  CrossLine start, end;
  std::uint32_t stretch = 0;
};

/// A bend that no mitre fits: both its segments end square, and the wedge on its outside is open.
struct OpenBend {
  Vec2 at, before, after;   ///< The point, and the directions of its segments.
  std::uint32_t slice = 0;  ///< The one that ends there; at the road's first point the one that begins there.
};

struct Slices {
  std::vector<Slice> slices;
  std::vector<OpenBend> bends;  ///< Sorted along the road.
};

/// Cuts a road across.
///
/// @param left_m, right_m  How far the lines reach to both sides.
/// @param tile_m           Of the plane's grid of tiles. Where the road comes within a metre of a border, and where it
///                         leaves it, are lines too: what changes beyond them moves no edge on the border.
/// Guarantees: lines of one slice do not cross within that; neighbours share their line unless the bend is open.
/// A stretch that would end within a bend ends at its vertex instead. O(points + stretches).
Slices slices_of(const Road& road, const StripEnds& ends, std::span<const RoadStretch> stretches, double left_m,
                 double right_m, double tile_m);

}  // namespace citykiln::roads
