// Faces too thin to be seen at a tolerance are given to a neighbour: kerbs, gaps between areas drawn twice, paths from
// afar. What simplify_borders() keeps by promise goes here on purpose.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "compiler/geometry/delaunay.h"
#include "compiler/ground/cover/border.h"

namespace citykiln::ground {

/// A connected piece between borders: its triangles are those of one region.
struct Region {
  std::uint32_t surface = 0;
  std::uint32_t merged_into = 0;     ///< Itself while it stays.
  std::int64_t twice_area = 0;       ///< Grid steps.
  double own_m2 = 0;                 ///< Without what it has taken.
  std::vector<std::uint32_t> faces;  ///< Its own, and those it has taken.
  bool touches_cell_border = false;
};

/// The faces between borders, triangulated: the same for all tolerances.
struct Regions {
  Delaunay net;
  std::vector<std::uint32_t> of_face;  ///< One a face of the net.
  std::vector<Region> regions;
};

/// @param borders  Meet only at their ends; the cell's own are among them.
/// A function of the set of borders. O(n log n).
Regions regions_between(std::span<const Border> borders);

struct MergedSlivers {
  std::vector<Border> borders;  ///< Sorted; a part of the old ones, some of new owners.
  std::uint32_t faces = 0;      ///< That have yielded.
  double area_m2 = 0;           ///< That has another surface now.
  double error_m = 0;           ///< No place that yielded was farther from the border of the face it yielded with.
};

/// Gives each thin face to the neighbour with whom it shares the longest border, the smallest face first. One that has
/// taken others has its turn again, as one face with them: so rows of thin faces yield while they are thin together.
///
/// @param thickness_m  >= 0. A face is thin if every point of it is proved to lie within this of its border: strips up
/// to about this width are, strips of more than twice the width never: half a tolerance spares all that is wider than
/// it.
/// @param may_merge    Says of a surface that its faces may go.
/// Guarantees: error_m <= thickness_m; faces on the cell's border stay, so cells meet as before; no vertex is new. A
/// function of the set of borders. Total.
/// Method: a constrained Delaunay triangulation of the borders; a triangle is thin if its corners are close to one
/// piece of border that starts at them, or its halves are. Cost: O(n log n), times the neighbours that yield to one
/// face.
MergedSlivers merge_slivers(const Regions& between, double thickness_m,
                            const std::function<bool(std::uint32_t)>& may_merge);
MergedSlivers merge_slivers(std::span<const Border> borders, double thickness_m,
                            const std::function<bool(std::uint32_t)>& may_merge);

}  // namespace citykiln::ground
