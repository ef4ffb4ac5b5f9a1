// Builds the roofs of roofs/ for roof operations.
#pragma once

#include <vector>

#include "grammars/derivation/roof_builder.h"
#include "grammars/roofs/roof.h"

namespace citykiln::grammars {

/// A roof builder that calls roofs::generate_roof(): gabled, hipped, pyramidal, skillion and mansard roofs with
/// overhangs on any footprint. Faces of one plane are one face.
/// @param tolerance_m  As in generate_roof(); > 0. The error of the roof is not part of that of the derivation.
/// std::nullopt for roofs that became flat, angles and heights that are not positive, overhangs below 0 or above 100 m,
/// and footprints farther than 256 km from the origin.
RoofBuilder form_roofs(double tolerance_m);

/// The faces of a roof over its eaves plane, z = 0; triangles of one plane are one face. Tagged kTop (roof planes),
/// kSide (gables), kBorder (rims and undersides of overhangs), kBottom (the floor, facing down). Guarantees: every face
/// is planar to 1 cm; no ring passes through a point twice; corners meet corners, so together with walls below the
/// eaves the surface is closed. O(n log n).
std::vector<Face> faces_of(const roofs::Roof& roof);

}  // namespace citykiln::grammars
