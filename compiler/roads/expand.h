// From an axis to the strip of ground it covers.
#pragma once

#include <vector>

#include "compiler/roads/recipe.h"

namespace citykiln::roads {

/// The strip as overlapping counter-clockwise rings: one quad a segment, a wedge or a disk at each bend, a disk at
/// rounded ends. Their union (where the sum of winding numbers is not zero) is the strip; it needs no union to be
/// computed and has no case that fails. Vertices are snapped to 2^-10 m; disks are 16-gons about the circle (border
/// error under 2 % of the half width). O(n).
std::vector<Ring> stroke(const Road& road);

/// The road with its pavements, likewise, square at its ends; empty where it has none. What lies between this and the
/// road's own strip is pavement.
std::vector<Ring> stroke_pavements(const Road& road);

}  // namespace citykiln::roads
