// Partitions a cell (a 128 m square of ground) into triangles, each covered by one land cover polygon. A ring is the
// outline of a polygon; a border is an edge between faces of different polygons.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "compiler/geometry/arrangement.h"
#include "compiler/geometry/box.h"
#include "compiler/geometry/triangles/delaunay.h"
#include "compiler/ground/cover/border.h"
#include "compiler/ground/recipe.h"

namespace citykiln::ground {

/// The edges, the triangles, and the polygon of each triangle: an index into the given polygons, or kNoLandCover.
struct Partition {
  Arrangement arrangement;
  Delaunay triangulation;
  std::vector<std::uint32_t> face_cover;
};

/// The polygons whose rings come near a cell.
struct NearbyCover {
  std::span<const LandCoverPolygon> surfaces;  ///< All polygons.
  std::vector<std::uint32_t> order;            ///< Indices of those near the cell, the topmost first.
};
/// Finds the polygons near a cell.
NearbyCover land_cover_near(std::span<const LandCoverPolygon> surfaces, const Box2& cell);

/// Partitions the cell along all rings, visible or hidden, and along further lines.
/// @param layers  Result of land_cover_near().
/// @param lines   Lines that become edges without being borders, each from its lower end to its upper one.
/// @param points  Points on the cell's border that become vertices.
Partition partition_all_rings(const NearbyCover& layers, std::span<const std::pair<GridPoint, GridPoint>> lines,
                              std::span<const GridPoint> points, const Box2& cell);

/// Returns the points where rings meet the cell's border, sorted. Hidden rings count, too, so both cells of a border
/// find the same points.
/// @param all  The arrangement of these rings and further lines. Snapping may bend a ring through a line's vertex on
///             the border; the ring then leaves the border there.
std::vector<GridPoint> ring_joints(const NearbyCover& layers, const Arrangement& all, const Box2& cell);

/// Returns the edges between faces of different polygons, and the cell's border, cut at its corners and at `joints` but
/// not at vertices that only lines have made. O(faces + joints · vertices on the border).
std::vector<Border> visible_borders(const Partition& partition, std::span<const GridPoint> joints);

/// Returns the pieces of the cell's border along which rings run, each with the neighbouring cell's polygon there. This
/// polygon is found by partitioning a narrow rectangle beyond the border with the same rings, lines and points.
/// O(polygons) per piece.
/// @param all  The arrangement of the cell.
std::vector<CellBorderPiece> cell_border_pieces(const NearbyCover& layers,
                                                std::span<const std::pair<GridPoint, GridPoint>> lines,
                                                std::span<const GridPoint> points, const Arrangement& all,
                                                const Box2& cell);

/// Returns the four sides of a cell without land cover as borders.
std::vector<Border> empty_cell_borders(const Box2& cell);

/// Treatment of edges that pass a vertex closely, in partition_of_borders().
enum class Rounding {
  kInside,  ///< Such edges are bent through the vertex, unless it is on the cell's border.
  kNone,    ///< Edges stay as they are, and must not cross (arrange_exactly()).
};

/// Partitions the cell along borders that were found before.
/// @param borders  Borders, including the cell's own, which give the polygon at the cell's south-west corner.
/// @param points   Further vertices on the cell's border.
/// @param lines    Lines in the closed cell that separate nothing, each from its lower end to its upper one.
/// Guarantees: the same polygons lie along the cell's border as before, and its vertices are ends of borders and of
/// lines, and points (arrange_inside()). Returns nothing if borders or lines cross; with Rounding::kInside only if they
/// cross at the cell's border.
std::optional<Partition> partition_of_borders(std::span<const Border> borders, std::span<const GridPoint> points,
                                              const Box2& cell, std::span<const std::pair<GridPoint, GridPoint>> lines,
                                              Rounding rounding);

}  // namespace citykiln::ground
