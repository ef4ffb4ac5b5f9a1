// Builds valid polygons from the rings of a broken area, which cross or touch themselves or each other. The result is
// the area that most renderers would draw.
#pragma once

#include <span>
#include <vector>

#include "compiler/source/osm_data.h"

namespace citykiln::source {

/// A ring, or an open line, of a broken area. The first point of a ring is repeated at the end.
struct AreaLine {
  std::vector<Location> points;
  bool is_inner = false;  ///< Its role: true for the border of a hole.
};

/// A polygon of longitudes and latitudes: the outer ring, counter-clockwise, then its holes, clockwise. Each ring
/// begins at its westernmost point; the first point is not repeated.
using MendedPolygon = std::vector<std::vector<Location>>;

/// Joins open lines of one role at common ends. Where several lines could continue, the first in order does. Lines that
/// remain open keep different first and last points. O(n²) in open lines.
std::vector<AreaLine> joined_lines(std::vector<AreaLine> lines);

/// Returns the area inside the outer rings, both lobes of a bow tie included, without the area inside the inner rings.
/// Spikes, and segments along which a ring runs twice, enclose nothing and vanish. Open lines are left out. Empty if
/// nothing is left, or if the rings have more than kMostMended points or are wider than 5°.
///
/// Guarantees: rings are simple and touch each other at points only; each point is less than 2e-7° from a given
/// segment.
std::vector<MendedPolygon> mended_polygons(std::span<const AreaLine> rings);

/// The largest number of points of all rings: the cost of an overlay grows with its square.
inline constexpr std::size_t kMostMended = 4096;

}  // namespace citykiln::source
