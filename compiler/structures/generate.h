// From a span to a bridge: a deck, what stands on its edges, and what it stands on.
#pragma once

#include <vector>

#include "compiler/materials/material_mesh.h"
#include "compiler/roads/markings/marking_layout.h"
#include "compiler/structures/recipe.h"

namespace citykiln::structures {

/// A mesh whose surface is marked: its uvs are the pattern's, u across and v along.
struct MarkedMesh {
  materials::MaterialMesh mesh;
  roads::MarkingLayout layout;
};

struct GeneratedStructure {
  std::vector<materials::MaterialMesh> meshes;
  std::vector<MarkedMesh> marked;
  double error_m = 0;  ///< How far what is left out moves the surface.
};

/// The bridge at a tolerance.
///
/// The deck is the span's road from edge to edge with its pavements and kerbs, between parapets or railings, on a slab;
/// at its end on the ground the slab lies on an abutment; piers carry it. Deck and slab together are closed, and so is
/// every other part. Where two spans meet in a joint their edges are the same points. Parts are left out from largest
/// tolerance on, the deck itself never; each says how far that moves the surface. Total: a span of which nothing is
/// left gives no mesh. O(points + knots + length) but for the thinning of ribs.
GeneratedStructure generate(const Span& bridge, double tolerance_m);

}  // namespace citykiln::structures
