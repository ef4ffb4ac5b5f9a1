// Crown hulls: closed meshes of a few triangles about the trunk, for coarse levels.
#pragma once

#include <span>

#include "compiler/geometry/mesh.h"
#include "compiler/plants/prototypes/foliage.h"

namespace citykiln::plants {

/// The hull of a plant.
struct CrownHull {
  Mesh mesh;
  double error_m = 0;  ///< A bound of the Hausdorff distance to the cards and the trunk's foot.
};

/// Returns a hull of 12 triangles: triangular rings at two heights, turned against each other. Each ring is as wide as
/// 70 % of the leaves at its height. Empty without leaf cards.
CrownHull crown_hull(const Foliage& foliage);

/// Returns the hull of a hedge: the box around most leaves, 12 triangles. Empty without cards.
CrownHull crown_box(const Foliage& foliage);

}  // namespace citykiln::plants
