// Generates the meshes of bridges from their recipes: deck, parapets or railings, piers, abutments and plates. Tunnels
// have meshes of their own (tunnel.h).
#pragma once

#include <vector>

#include "compiler/materials/material_mesh.h"
#include "compiler/roads/markings/marking_layout.h"
#include "compiler/structures/recipe.h"

namespace citykiln::structures {

/// A part of a road's surface with painted markings. Its texture coordinates are metres in the marking layout: u across
/// the road, v along it.
struct MarkedMesh {
  materials::MaterialMesh mesh;
  roads::MarkingLayout layout;
};

/// The meshes of one bridge or tunnel.
struct GeneratedStructure {
  std::vector<materials::MaterialMesh> meshes;  ///< Parts without markings.
  std::vector<MarkedMesh> marked;               ///< Strips of the road with markings.
  double error_m = 0;  ///< Upper bound of the deviation of the surface that omitted parts and cross-sections cause.
};

/// Generates a bridge, in plane metres, and the plates that are stored with it (plate_mesh.h). The deck is the road
/// with pavements and kerbs, between parapets or railings, on a slab. It rests on piers and, at ends on the ground, on
/// abutments. Deck and slab together are closed, unless the slab is left out, and so is every other part.
///
/// A bridge that a plate carries has no slab, parapets and railings of its own (DeckForm): kPlate keeps road, kerbs and
/// supports, kNone, the axis of an area, only piers.
///
/// Guarantees: error_m <= tolerance_m; bridges that meet in a joint have the same vertices there. Cannot fail; a bridge
/// without length has no mesh but those of its plates. O(points · knots + length), plus the simplification of its
/// cross-sections (simplify_ribs()).
/// @param bridge       The recipe: a road with profile, ends and piers.
/// @param tolerance_m  Largest deviation, > 0. A part other than the deck is left out if that moves the surface by
///                     less.
GeneratedStructure generate(const Span& bridge, double tolerance_m);

}  // namespace citykiln::structures
