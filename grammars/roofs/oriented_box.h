// The oriented bounding box of a footprint, in which roofs are laid out.
#pragma once

#include <optional>
#include <span>

#include "compiler/geometry/vec.h"

namespace citykiln::roofs {

/// A rectangle around a footprint, with axes along and across the ridge.
struct OrientedBox {
  Vec2 origin;                     ///< A corner of the footprint.
  Vec2 along, across;              ///< Unit vectors; across is left of along. Ridges run along.
  double from_m = 0, to_m = 0;     ///< The extent of the footprint in the direction `along`, from the origin.
  double back_m = 0, front_m = 0;  ///< The extent in the direction `across`; the main roof plane faces the front.
  double width_m() const { return front_m - back_m; }
  double length_m() const { return to_m - from_m; }
  double along_m(Vec2 p) const { return dot(along, p - origin); }
  double across_m(Vec2 p) const { return dot(across, p - origin); }
  Vec2 position(double along_m, double across_m) const { return origin + along * along_m + across * across_m; }
};

/// Returns the smallest box that has a side along an edge of the ring; among equal boxes the one along the longest
/// edge. O(n²).
/// @param ring             Not empty.
/// @param direction        The downhill direction of the main roof plane, of any length above 0. The front of the box
/// is the side that faces it within 25 degrees; if there is none, the box is turned to the direction.
/// @param is_ridge_across  `along` is the shorter side of the box instead of the longer one. Ignored if `direction` is
/// given.
OrientedBox oriented_box(std::span<const Vec2> ring, std::optional<Vec2> direction, bool is_ridge_across);

}  // namespace citykiln::roofs
