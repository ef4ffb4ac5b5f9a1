// From a span to a slab.
#pragma once

#include <vector>

#include "compiler/materials/dressed_mesh.h"
#include "compiler/structures/recipe.h"

namespace citykiln::structures {

struct Expanded {
  std::vector<materials::DressedMesh> meshes;
  double error_m = 0;
};

/// The deck of a bridge: road surface on top, a concrete slab of kDeckThickness_m under it, mitred at bends. Closed.
/// The same at every tolerance up to the slab's thickness; above it the deck alone, with the thickness as its error.
Expanded expand(const Span& bridge, double tolerance_m);

}  // namespace citykiln::structures
