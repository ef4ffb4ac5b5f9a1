// The edges of a baked tile's ground on the border of the tile, to compare them with those of the neighbouring tile.
#pragma once

#include <array>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/geometry/vec.h"

namespace citykiln::verify {

/// An edge of a triangle of the ground, or of a wall or skirt, on the border of a tile, in plane metres. The ends are
/// ordered by x, then y, then z.
using BorderEdge = std::array<Vec3, 2>;

/// The border edges on one side of a tile, sorted.
struct BorderEdges {
  std::vector<BorderEdge> ground;    ///< Edges of triangles that are visible from above.
  std::vector<BorderEdge> vertical;  ///< Edges of vertical triangles in the border plane: walls and skirts.
};

/// Returns the edges of ground triangles in the plane x = at (or y = at), without vertical edges. O(n log n).
BorderEdges border_edges_at_x(const bake::BakedTile& tile, double at);
BorderEdges border_edges_at_y(const bake::BakedTile& tile, double at);

/// True if the ground of two neighbouring tiles meets without gaps: both have the same edges on their common side or,
/// where a border between surfaces runs along that side, a vertical face of one tile closes the difference.
bool borders_match(const BorderEdges& own, const BorderEdges& other);

}  // namespace citykiln::verify
