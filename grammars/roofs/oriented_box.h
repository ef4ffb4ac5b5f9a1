// How a footprint lies: the box about it that its roof is laid out in.
#pragma once

#include <optional>
#include <span>

#include "compiler/geometry/vec.h"

namespace citykiln::roofs {

/// A box turned as the footprint is.
struct OrientedBox {
  Vec2 origin;                     ///< A corner of the footprint.
  Vec2 along, across;              ///< Unit length; across is left of along. Ridges run along.
  double from_m = 0, to_m = 0;     ///< What the footprint covers along, counted from the origin.
  double back_m = 0, front_m = 0;  ///< And across; the main face looks to the front.
  double width_m() const { return front_m - back_m; }
  double length_m() const { return to_m - from_m; }
  double along_m(Vec2 p) const { return dot(along, p - origin); }
  double across_m(Vec2 p) const { return dot(across, p - origin); }
  Vec2 place(double along_m, double across_m) const { return origin + along * along_m + across * across_m; }
};

/// The smallest box along one of the ring's edges; the longer edge's where two are as small. `along` is its longer
/// side, or the shorter where is_ridge_across. A direction turns it: to the nearest of the box's four sides if that is
/// less than 25° off, else exactly. O(n²).
OrientedBox frame_of(std::span<const Vec2> ring, std::optional<Vec2> direction, bool is_ridge_across);

}  // namespace citykiln::roofs
