// Generates bridges: deck, parapets and railings, piers and abutments.
#pragma once

#include <vector>

#include "compiler/materials/material_mesh.h"
#include "compiler/roads/markings/marking_layout.h"
#include "compiler/structures/recipe.h"

namespace citykiln::structures {

/// A mesh with road markings. Its texture coordinates are metres in the layout: u across, v along.
struct MarkedMesh {
  materials::MaterialMesh mesh;
  roads::MarkingLayout layout;
};

struct GeneratedStructure {
  std::vector<materials::MaterialMesh> meshes;
  std::vector<MarkedMesh> marked;
  double error_m = 0;  ///< Largest deviation of the surface that omitted parts cause.
};

/// Generates a bridge at a tolerance, > 0.
///
/// The deck is the road with pavements and kerbs, between parapets or railings, on a slab. It rests on piers and, at
/// ends on the ground, on abutments. Deck and slab together are closed, and so is every other part. Spans that meet in
/// a joint have the same vertices there. Parts other than the deck are left out if that moves the surface by less than
/// the tolerance. A span without length has no mesh. O(points + knots + length), plus the simplification of ribs.
GeneratedStructure generate(const Span& bridge, double tolerance_m);

}  // namespace citykiln::structures
