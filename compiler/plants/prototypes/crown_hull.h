// Crown hulls: closed meshes of a few triangles, surfaces of revolution about the trunk, for coarse levels.
#pragma once

#include <span>

#include "compiler/geometry/mesh.h"
#include "compiler/plants/prototypes/foliage.h"

namespace citykiln::plants {

struct CrownHull {
  Mesh mesh;
  double error_m = 0;  ///< Bound of the Hausdorff distance to the cards and the trunk's foot.
};

/// Triangular rings at two heights, turned against each other, each as wide as 70 % of the leaves there: 12 triangles.
/// Without cards the mesh is empty.
CrownHull crown_hull(const Foliage& foliage);

/// For hedges: the box around most leaves, 12 triangles. Without cards the mesh is empty.
CrownHull crown_box(const Foliage& foliage);

}  // namespace citykiln::plants
