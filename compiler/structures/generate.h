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

/// Generates a bridge, in plane metres, z up, and the plates that are stored with it (plate_mesh.h). A plate is a deck
/// that the map has as an area; it may carry several bridges. DeckForm says which parts a bridge has itself:
///
/// - kOwn: the road with pavements and kerbs, on a slab between parapets or railings. The slab rests on piers and, at
///   ends on the ground, on abutments.
/// - kPlate: road, kerbs, piers and abutments. The plate takes the place of slab, parapets and railings.
/// - kNone: the bridge is only the axis of a plate. It has piers and nothing else.
///
/// Road and slab together are a closed surface; without the slab, the road's surface is open. Each pier, abutment and
/// railing is closed on its own.
///
/// @param bridge       The recipe: a road with profile, ends and piers.
/// @param tolerance_m  Largest deviation, > 0. A part other than the road is left out if that moves the surface by
///                     less.
///
/// Guarantees: error_m <= tolerance_m; bridges that meet in a joint have the same vertices there. Cannot fail; a bridge
/// without length has no mesh but those of its plates. O(points · knots + length), plus the simplification of its
/// cross-sections (simplify_ribs()).
GeneratedStructure generate(const Span& bridge, double tolerance_m);

}  // namespace citykiln::structures
