// Segments that cross anyhow become edges that meet only at their ends, on the 2^-10 m grid, cell by cell.
//
//      \  /          every grid point that is an end or next to a crossing is hot;     •  •
//   ----\/----       a segment that passes within half a grid step of a hot point   •---•---•
//       /\           is bent through it                                                •  •
#pragma once

#include <cmath>
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "compiler/contract/tolerance.h"
#include "compiler/geometry/box.h"
#include "compiler/geometry/vec.h"

namespace citykiln {

/// A point of the plane's grid, in units of 2^-10 m. |x|, |y| < 2^29 (524 km).
struct GridPoint {
  std::int64_t x = 0, y = 0;
  auto operator<=>(const GridPoint&) const = default;
};

/// Exact for snapped points.
inline GridPoint grid_point(Vec2 p) {
  return {static_cast<std::int64_t>(std::floor(p.x / kQuantum_m + 0.5)),
          static_cast<std::int64_t>(std::floor(p.y / kQuantum_m + 0.5))};
}
inline Vec2 plane_point(GridPoint p) {
  return {static_cast<double>(p.x) * kQuantum_m, static_cast<double>(p.y) * kQuantum_m};
}

/// A piece of a closed ring: walking from a to b, `owner` lies to the left, `winding` times.
struct OwnedSegment {
  GridPoint a, b;
  std::uint32_t owner = 0;
  std::int32_t winding = 1;
};

/// Crossing an edge from its right to its left (walking from a to b) adds `winding` to how often one is inside of
/// `owner`.
struct WindingStep {
  std::uint32_t owner = 0;
  std::int32_t winding = 0;
};

struct ArrangedEdge {
  std::uint32_t a = 0, b = 0;          ///< Into vertices, a < b.
  std::uint32_t first = 0, count = 0;  ///< Into steps. None: a piece of the cell's border that no ring runs along.
};

struct Arrangement {
  std::vector<GridPoint> vertices;  ///< Sorted.
  std::vector<ArrangedEdge>
      edges;  ///< Sorted by (a, b). No two cross, touch or overlap but at their ends. The cell's border is among them.
  std::vector<WindingStep> steps;  ///< Per edge sorted by owner.
};

/// True where the segment passes p so closely that arrange() bends it through p if p is hot. Exact.
bool passes(const OwnedSegment& segment, GridPoint p);

/// The part in a closed cell of the snap-rounded arrangement of all segments and of all cells' border lines.
///
/// @param segments  Any that may touch the cell; none is clipped before.
/// @param points    Further hot points; those outside the cell are ignored.
/// @param cell      Corners on whole metres.
/// Guarantees: no segment moves by more than 2^-11 m in x or in y; vertices on the cell's border depend only on
/// segments and points within 2^-10 m of it, so two cells that share a border share its vertices; ring edges whose
/// windings cancel are gone, vertices on the border stay. Cost: O(n log n + crossings) for segments spread over the
/// cell. Source: Hobby, "Practical segment intersection with finite precision output", Comput. Geom. 13, 1999; all
/// tests exact in 64 and 128 bits.
Arrangement arrange(std::span<const OwnedSegment> segments, std::span<const GridPoint> points, const Box2& cell);

}  // namespace citykiln
