// Lines across a road: where its segments meet and where its stretches change.
#pragma once

#include <span>
#include <vector>

#include "compiler/roads/expand.h"
#include "compiler/roads/stretches.h"

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
  std::uint32_t slice = 0;  ///< The one that ends there.
};

struct Slices {
  std::vector<Slice> slices;
  std::vector<OpenBend> bends;
};

/// Cuts a road across.
///
/// @param left_m, right_m  How far the lines reach to both sides.
/// Guarantees: lines of one slice do not cross within that; neighbours share their line unless the bend is open.
/// A stretch that would end within a bend ends at its vertex instead. O(points + stretches).
Slices slices_of(const Road& road, const Ends& ends, std::span<const StretchRun> stretches, double left_m,
                 double right_m);

}  // namespace citykiln::roads
