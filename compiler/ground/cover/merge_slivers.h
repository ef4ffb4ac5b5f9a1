// Merges faces that are too thin to see at a tolerance into a neighbour, such as kerbs, gaps between areas drawn twice,
// and distant paths. simplify_borders() never drops a face, so this step precedes it.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "compiler/geometry/triangles/delaunay.h"
#include "compiler/ground/cover/border.h"

namespace citykiln::ground {

/// A face between borders: a connected set of triangles of one land cover polygon.
struct CoverFace {
  std::uint32_t polygon = 0;         ///< The number of its polygon, as in Border.
  std::uint32_t merged_into = 0;     ///< The face it was merged into; its own index while it stays.
  std::int64_t twice_area = 0;       ///< Twice its area, in square grid steps.
  double own_m2 = 0;                 ///< Its area without merged faces.
  double inner_radius_m = 0;         ///< The radius of the largest circle inside one of its triangles.
  std::vector<std::uint32_t> faces;  ///< Its triangles, and those of merged faces.
  bool touches_cell_border = false;
};

/// All faces between borders, triangulated. They do not depend on the tolerance.
struct CoverFaces {
  Delaunay net;
  std::vector<std::uint32_t> of_face;  ///< For each triangle of the net, an index into `cover_faces`.
  std::vector<CoverFace> cover_faces;
};

/// Triangulates borders and finds the faces between them. The result depends on the set of borders, not on their order.
/// O(n log n).
/// @param borders  Borders that meet only at their ends, including the cell's own.
CoverFaces faces_between(std::span<const Border> borders);

struct MergedSlivers {
  std::vector<Border> borders;  ///< The remaining borders, sorted, with the polygons that are beside them now.
  std::uint32_t faces = 0;      ///< Number of merged faces.
  double area_m2 = 0;           ///< The area that belongs to another polygon now.
  double error_m = 0;           ///< Largest distance of a merged place from the border of the face it was merged with.
};

/// Merges each thin face into the neighbour with which it shares the longest border, the smallest face first. A face
/// into which others were merged is tested again together with them, so a row of thin faces is merged as long as it is
/// thin as a whole.
///
/// @param thickness_m  >= 0. A face is thin if every point of it is proved to lie within this of its border: true for
///                     strips up to about this width, false for strips of more than twice the width.
/// @param may_merge    True if a face may be merged into a neighbour; it is given with those merged into it.
/// Guarantees: error_m <= thickness_m; faces on the cell's border stay, so cells still meet; there are no new vertices.
/// Depends on the set of borders only. O(n log n), times the neighbours merged into one face.
/// Method: in a constrained Delaunay triangulation of the borders a triangle is thin if its corners are close to one
/// piece of border that starts at them, or if both of its halves are thin.
MergedSlivers merge_slivers(const CoverFaces& between, double thickness_m,
                            const std::function<bool(const CoverFace&)>& may_merge);
MergedSlivers merge_slivers(std::span<const Border> borders, double thickness_m,
                            const std::function<bool(const CoverFace&)>& may_merge);

}  // namespace citykiln::ground
