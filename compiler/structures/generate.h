// Generates the meshes of bridges from their recipes: deck, parapets or railings, piers and abutments.
#pragma once

#include <vector>

#include "compiler/materials/material_mesh.h"
#include "compiler/roads/markings/marking_layout.h"
#include "compiler/structures/recipe.h"

namespace citykiln::structures {

/// A strip of road with painted markings. Its texture coordinates are metres in the marking layout: u across, v along.
struct MarkedMesh {
  materials::MaterialMesh mesh;
  roads::MarkingLayout layout;
};

/// The meshes of one bridge or tunnel.
struct GeneratedStructure {
  std::vector<materials::MaterialMesh> meshes;  ///< Parts without markings.
  std::vector<MarkedMesh> marked;               ///< Strips of the road with markings.
  double error_m = 0;                           ///< Largest deviation of the surface that omitted parts and ribs cause.
};

/// Generates a bridge. The deck is the road with pavements and kerbs, between parapets or railings, on a slab. It rests
/// on piers and, at ends on the ground, on abutments. Deck and slab together are closed, unless the slab is left out,
/// and so is every other part.
///
/// @param bridge       The recipe: a road with profile, ends and piers.
/// @param tolerance_m  Largest deviation, > 0. A part other than the deck is left out if that moves the surface by
///                     less.
///
/// Bridges that meet in a joint have the same vertices there. A bridge without length has no mesh. O(points · knots +
/// length), plus the simplification of ribs.
GeneratedStructure generate(const Span& bridge, double tolerance_m);

}  // namespace citykiln::structures
