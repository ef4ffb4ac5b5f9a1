// Makes an area of rings that cross or touch themselves or each other: what most readers would draw.
#pragma once

#include <span>
#include <vector>

#include "compiler/source/osm_data.h"

namespace citykiln::source {

/// A ring, or an open line, of a broken area. The first point of a ring is repeated at the end.
struct BrokenLine {
  std::vector<Location> points;
  bool is_inner = false;
};

/// A polygon of longitudes and latitudes: the outer ring, then its holes. The first point is not repeated.
using MendedPolygon = std::vector<std::vector<Location>>;

/// Joins open lines of one role at their ends. Lines that remain open keep their first point apart from their last.
/// Method: at each end the first line in order that begins or ends there goes on.
std::vector<BrokenLine> joined_lines(std::vector<BrokenLine> lines);

/// Returns the area inside the outer rings, both lobes of a bow tie, without what lies inside the inner rings. Spikes
/// and segments that are there twice have no area. Open lines are left out. Empty if nothing is left, or if the rings
/// are longer than kMostMended segments or wider than 5°.
///
/// Guarantees: rings are simple and touch each other at points only; each point is less than 2e-7° from a segment.
std::vector<MendedPolygon> mended_polygons(std::span<const BrokenLine> rings);

/// The largest number of segments: the cost of an overlay is their square.
inline constexpr std::size_t kMostMended = 4096;

}  // namespace citykiln::source
