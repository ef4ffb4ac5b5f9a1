// Merges faces that are too thin to see at a tolerance into a neighbour: kerbs, gaps between areas drawn twice, distant
// paths. simplify_borders() never drops a face; this does.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "compiler/geometry/delaunay.h"
#include "compiler/ground/cover/border.h"

namespace citykiln::ground {

/// A connected set of triangles between borders.
struct Region {
  std::uint32_t surface = 0;
  std::uint32_t merged_into = 0;     ///< The region it was merged into; itself while it stays.
  std::int64_t twice_area = 0;       ///< In grid steps.
  double own_m2 = 0;                 ///< Without merged regions.
  std::vector<std::uint32_t> faces;  ///< Its own and those merged into it.
  bool touches_cell_border = false;
};

/// The triangulated faces between borders, the same for all tolerances.
struct Regions {
  Delaunay net;
  std::vector<std::uint32_t> of_face;  ///< The region of each face of the net.
  std::vector<Region> regions;
};

/// Triangulates borders and finds their regions. The result depends on the set of borders, not on their order. O(n log
/// n).
/// @param borders  Meet only at their ends; the cell's own are among them.
Regions regions_between(std::span<const Border> borders);

struct MergedSlivers {
  std::vector<Border> borders;  ///< Sorted; some of the given ones, some with new polygons beside them.
  std::uint32_t faces = 0;      ///< How many were merged.
  double area_m2 = 0;           ///< The area that belongs to another polygon now.
  double error_m = 0;           ///< Largest distance of a merged place from the border of the face it was merged with.
};

/// Merges each thin face into the neighbour with which it shares the longest border, the smallest face first. A face
/// that others were merged into is judged again, together with them, so rows of thin faces merge while they are thin
/// together.
///
/// @param thickness_m  >= 0. A face is thin if every point of it is proved to lie within this of its border: true for
///                     strips up to about this width, false for strips of more than twice the width.
/// @param may_merge    Tells of a polygon whether its faces may be merged.
/// Guarantees: error_m <= thickness_m; faces on the cell's border stay, so cells still meet; no vertex is new. Depends
/// on the set of borders alone. Total. O(n log n), times the neighbours merged into one face.
/// Method: in a constrained Delaunay triangulation of the borders a triangle is thin if its corners are close to one
/// piece of border that starts at them, or if both of its halves are thin.
MergedSlivers merge_slivers(const Regions& between, double thickness_m,
                            const std::function<bool(std::uint32_t)>& may_merge);
MergedSlivers merge_slivers(std::span<const Border> borders, double thickness_m,
                            const std::function<bool(std::uint32_t)>& may_merge);

}  // namespace citykiln::ground
