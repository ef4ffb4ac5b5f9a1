// Snap rounding: turns arbitrary segments into edges on the 2^-10 m grid that meet at their ends only, cell by cell.
//
//      \  /          every segment end, and the grid point nearest to each crossing,   •  •
//   ----\/----       is a hot point; a segment that passes the unit square of a hot  •---•---•
//       /\           point is bent through it                                          •  •
#pragma once

#include <cassert>
#include <cmath>
#include <compare>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "compiler/contract/tolerance.h"
#include "compiler/geometry/box.h"
#include "compiler/geometry/vec.h"

namespace citykiln {

/// A point of the plane's grid in units of 2^-10 m. |x|, |y| < 2^29 (524 km).
struct GridPoint {
  std::int64_t x = 0, y = 0;
  auto operator<=>(const GridPoint&) const = default;
};

/// Returns the grid point nearest to a place in plane metres. Exact for snapped points.
inline GridPoint grid_point(Vec2 p) {
  return {static_cast<std::int64_t>(std::floor(p.x / kQuantum_m + 0.5)),
          static_cast<std::int64_t>(std::floor(p.y / kQuantum_m + 0.5))};
}
inline Vec2 plane_point(GridPoint p) {
  return {static_cast<double>(p.x) * kQuantum_m, static_cast<double>(p.y) * kQuantum_m};
}

/// Returns twice the signed area of the triangle a, b, c: positive if a, b, c turn left. Exact.
inline std::int64_t turn(GridPoint a, GridPoint b, GridPoint c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// An edge of a closed ring. The area of `owner` lies to the left of a → b, `winding` times.
struct OwnedSegment {
  GridPoint a, b;
  std::uint32_t owner = 0;
  std::int32_t winding = 1;
};

/// The difference of `owner`'s winding number on the left of an edge less the one on its right (seen from a to b).
struct WindingStep {
  std::uint32_t owner = 0;
  std::int32_t winding = 0;
};

struct ArrangedEdge {
  std::uint32_t a = 0, b = 0;  ///< Indices into Arrangement::vertices, a < b.
  /// The edge's range of Arrangement::steps. Empty: a part of the cell's border that no ring follows.
  std::uint32_t first = 0, count = 0;
};

struct Arrangement {
  std::vector<GridPoint> vertices;  ///< Sorted.
  std::vector<ArrangedEdge> edges;  ///< Sorted by (a, b). Any two share at most an end. Includes the cell's border.
  std::vector<WindingStep> steps;   ///< Grouped by edge, sorted by owner within an edge.
};

/// True if the segment passes the half-open unit square about p. If p is a hot point, arrange() bends such a segment
/// through p. Exact.
bool passes(const OwnedSegment& segment, GridPoint p);

/// Returns the snap-rounded arrangement of all segments and the border lines of all cells, cut to one closed cell.
///
/// @param segments  All segments that may touch the cell, unclipped.
/// @param points    Further hot points; those outside the cell are ignored.
/// @param cell      Corners on whole metres.
/// Guarantees: no segment moves by more than 2^-11 m in x or y; vertices on the cell's border depend only on segments
/// and points within 2^-10 m of it, so that neighbouring cells have the same border vertices; ring edges whose windings
/// cancel are removed, vertices on the border remain. Cost: O(n log n + crossings) for evenly spread segments. Source:
/// Hobby, "Practical segment intersection with finite precision output", Comput. Geom. 13, 1999; all tests are exact in
/// 64 and 128 bits.
Arrangement arrange(std::span<const OwnedSegment> segments, std::span<const GridPoint> points, const Box2& cell);

/// Arranges segments that have been rounded before, such as edges of an arrangement of the same cell and parts of them.
/// arrange() is not suited to them: it may bend a segment through a vertex of the cell's border that the original
/// segment does not pass. Then the faces beside the border are not the ones that the neighbouring cell expects.
///
/// @param segments  In the closed cell; those along its border have no other vertex of the border between their ends.
/// Guarantees: as arrange(), and vertices on the cell's border are `points`, the cell's corners and ends of segments;
/// only segments that end there meet them, so the same faces lie beside each piece of the border as before. (Bending a
/// segment never moves it over a border vertex, as the cell is convex.) Returns nothing if two segments cross within
/// half a grid step of the border, as no grid point inside the cell is nearest to such a crossing. Segments that meet
/// only at their ends always have an arrangement. Cost: as arrange().
std::optional<Arrangement> arrange_inside(std::span<const OwnedSegment> segments, std::span<const GridPoint> points,
                                          const Box2& cell);

/// Arranges segments that meet at their ends or at `points` only, without rounding: edges of triangulations and parts
/// of them. A segment is split at ends of others and at points that lie exactly on it, and does not move. Returns
/// nothing if two segments cross between their ends. Otherwise as arrange_inside().
std::optional<Arrangement> arrange_exactly(std::span<const OwnedSegment> segments, std::span<const GridPoint> points,
                                           const Box2& cell);

}  // namespace citykiln
