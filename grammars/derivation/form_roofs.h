// The roofs of roofs/ as the grammar's roof builder.
#pragma once

#include <vector>

#include "grammars/derivation/roof_builder.h"
#include "grammars/roofs/roof.h"

namespace citykiln::grammars {

/// Makes roofGable … by generate_roof(): gabled, hipped, pyramidal, skillion and mansard, on any footprint, with
/// overhangs.
/// @param tolerance_m  As generate_roof's: knees and eaves it does not see are left out. The roof's own error is not
/// part of the derivation's. Faces of one plane are one face. Rims and undersides of overhangs are tagged kBorder.
/// std::nullopt where the roof fell back to flat, for what does not rise, overhangs below 0 or over 100 m, and places
/// off the grid (256 km).
RoofBuilder form_roofs(double tolerance_m);

/// A roof as faces, eaves at height 0: those of one plane are one. Tagged kTop (roof planes), kSide (gables), kBorder
/// (rims and undersides of overhangs), kBottom (the floor, looking down).
/// Guarantees: every face is flat to a centimetre; no ring comes back to one of its points; corners meet corners, so
/// that with walls below its eaves the roof closes. O(n log n).
std::vector<Face> faces_of(const roofs::Roof& roof);

}  // namespace citykiln::grammars
