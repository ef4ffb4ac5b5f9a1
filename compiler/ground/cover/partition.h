// Partitions a cell into triangles, each covered by one land cover polygon.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "compiler/geometry/arrangement.h"
#include "compiler/geometry/box.h"
#include "compiler/geometry/delaunay.h"
#include "compiler/ground/cover/border.h"
#include "compiler/ground/recipe.h"

namespace citykiln::ground {

/// The edges, the triangles, and the polygon of each triangle: an index into the polygons given, or kNoLandCover.
struct Partition {
  Arrangement arrangement;
  Delaunay triangulation;
  std::vector<std::uint32_t> face_cover;
};

/// The polygons whose rings come near a cell, from the top down.
struct NearbyCover {
  std::span<const LandCoverPolygon> surfaces;
  std::vector<std::uint32_t> order;
};
NearbyCover land_cover_near(std::span<const LandCoverPolygon> surfaces, const Box2& cell);

/// Partitions the cell along all rings, visible or hidden, and along further lines.
/// @param lines   From the lower end to the upper; they separate nothing.
/// @param points  On the cell's border.
Partition partition_all_rings(const NearbyCover& layers, std::span<const std::pair<GridPoint, GridPoint>> lines,
                              std::span<const GridPoint> points, const Box2& cell);

/// Returns where rings meet the cell's border, sorted. Hidden rings count too, so both cells of a border find the same
/// places.
/// @param all  The arrangement of the same rings with lines: a ring that snapping bends through a vertex of a line on
///             the border may leave the border there.
std::vector<GridPoint> ring_joints(const NearbyCover& layers, const Arrangement& all, const Box2& cell);

/// Returns the edges between faces of different polygons, and the cell's border cut at its corners and at `joints`;
/// other vertices, which only lines have made, are left out. O(faces + joints · vertices on the border).
std::vector<Border> visible_borders(const Partition& partition, std::span<const GridPoint> joints);

/// Returns where rings run along the cell's border and what the neighbouring cell has there. It is found by
/// partitioning a strip beyond the border with the same rings, lines and points: all that decides it lies within a grid
/// step. O(polygons) per piece.
std::vector<CellBorderPiece> cell_border_pieces(const NearbyCover& layers,
                                                std::span<const std::pair<GridPoint, GridPoint>> lines,
                                                std::span<const GridPoint> points, const Arrangement& all,
                                                const Box2& cell);

/// Returns the border of a cell without land cover.
std::vector<Border> empty_cell_borders(const Box2& cell);

/// How borders and lines that were found before are arranged.
enum class Rounding {
  kInside,  ///< Those that pass a vertex closely are bent through it, unless it is on the cell's border.
  kNone,    ///< They must not cross (arrange_exactly).
};

/// Partitions the cell along borders that were found before: those given, and the points given on the cell's border.
/// @param borders  Include the cell's own, from which the polygon at its south-west corner is read.
/// @param lines    In the closed cell, from the lower end to the upper; they separate nothing.
/// Guarantees: the same polygons lie along the cell's border as before, and its vertices are ends of borders, of lines
/// and points (arrange_inside). Returns nothing where borders or lines cross, with rounding only at the cell's border.
std::optional<Partition> partition_of_borders(std::span<const Border> borders, std::span<const GridPoint> points,
                                              const Box2& cell, std::span<const std::pair<GridPoint, GridPoint>> lines,
                                              Rounding rounding);

}  // namespace citykiln::ground
