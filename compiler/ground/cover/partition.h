// What covers a cell: a planar partition of it into triangles, each of one surface.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "compiler/geometry/arrangement.h"
#include "compiler/geometry/box.h"
#include "compiler/geometry/delaunay.h"
#include "compiler/ground/cover/border.h"
#include "compiler/ground/recipe.h"

namespace citykiln::ground {

/// The edges, the triangles, and what covers each of them (an index into the surfaces given, or kNoLandCover).
struct Partition {
  Arrangement arrangement;
  Delaunay triangulation;
  std::vector<std::uint32_t> face_cover;
};

/// The surfaces whose rings come near a cell, from the top down.
struct NearbyCover {
  std::span<const LandCoverPolygon> surfaces;
  std::vector<std::uint32_t> order;
};
NearbyCover land_cover_near(std::span<const LandCoverPolygon> surfaces, const Box2& cell);

/// Everything that is drawn, whether seen or hidden, with further lines as edges, and what lies on top in each face.
/// @param lines   From the lower end to the upper; they bound nothing.
/// @param points  On the cell's border.
Partition partition_all_rings(const NearbyCover& layers, std::span<const std::pair<GridPoint, GridPoint>> lines,
                              std::span<const GridPoint> points, const Box2& cell);

/// Where rings meet the cell's border, sorted: hidden ones too, so that both cells of a border have the same.
/// @param all  Of the same layers, with lines: a ring that is bent through one of their vertices on the border may
///             leave the border there.
std::vector<GridPoint> ring_joints(const NearbyCover& layers, const Arrangement& all, const Box2& cell);

/// The edges between faces of different surfaces, and the cell's border from corner to corner and joint to joint:
/// vertices that only lines have put there are left out. O(faces + joints times vertices on the border).
std::vector<Border> visible_borders(const Partition& partition, std::span<const GridPoint> joints);

/// Where rings run along the cell's border, and what the cell beyond it has there: from the same borders, lines and
/// points that make up this one's partition, as all that decides it lies within a grid step. O(layers) a piece.
std::vector<CellBorderPiece> cell_border_pieces(const NearbyCover& layers,
                                                std::span<const std::pair<GridPoint, GridPoint>> lines,
                                                std::span<const GridPoint> points, const Arrangement& all,
                                                const Box2& cell);

/// The border of a cell in which nothing lies.
std::vector<Border> empty_cell_borders(const Box2& cell);

/// The same cell, of other borders: those given between surfaces, and the points given on the cell's border.
/// @param borders  The cell's own border among them: what covers its south-western corner is told there.
Partition partition_of_borders(std::span<const Border> borders, std::span<const GridPoint> points, const Box2& cell);

}  // namespace citykiln::ground
