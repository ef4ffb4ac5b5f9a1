// Connects roof operations with the roof generator in roofs/.
#pragma once

#include <vector>

#include "grammars/derivation/roof_builder.h"
#include "grammars/roofs/roof.h"

namespace citykiln::grammars {

/// Returns a roof builder that calls roofs::generate_roof(): gabled, hipped, pyramidal, skillion and mansard roofs with
/// overhangs on any footprint. Triangles of one plane become one face. It returns std::nullopt for roofs that became
/// flat, angles and heights that are not positive, overhangs below 0 or above 100 m, and footprints farther than 256 km
/// from the origin.
/// @param tolerance_m   The tolerance of generate_roof(), > 0. Derivation::error_m does not include the error of roofs.
RoofBuilder form_roofs(double tolerance_m);

/// Returns the faces of a roof whose eaves plane is z = 0. Triangles of one plane become one face. Tags: kTop (roof
/// planes), kSide (gables), kBorder (rims and undersides of overhangs), kBottom (the floor, facing down). Guarantees:
/// every face is planar to 1 cm; no ring passes through a point twice; corners meet corners, so the surface is closed
/// together with walls below the eaves. O(n log n).
std::vector<Face> faces_of(const roofs::Roof& roof);

}  // namespace citykiln::grammars
