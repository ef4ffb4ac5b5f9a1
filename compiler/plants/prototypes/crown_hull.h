// A plant from very far: a closed body of a few triangles, turned about the trunk to the crown's outline.
#pragma once

#include <span>

#include "compiler/geometry/mesh.h"
#include "compiler/plants/prototypes/foliage.h"

namespace citykiln::plants {

struct CrownHull {
  Mesh mesh;
  double error_m = 0;  ///< Hausdorff, both ways, to the cards and the trunk's foot; bounded by pieces.
};

/// Rings of six at shares of the crown's height, each as wide as most of the leaves there reach.
/// Total: no cards give no mesh.
CrownHull crown_hull(const Foliage& foliage);

/// What is clipped: the box about most of its leaves, of 12 triangles. Error and totality as above.
CrownHull crown_box(const Foliage& foliage);

}  // namespace citykiln::plants
