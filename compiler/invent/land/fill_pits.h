// Fills pits, so that water from every point of a lattice reaches its border.
#pragma once

#include "compiler/invent/land/lattice.h"

namespace citykiln::invent {

/// The fall of a filled pit's surface towards its outlet, from point to point.
inline constexpr double kPitFall_m = 0.002;

/// Raises points until each one inside the border has a neighbour that is lower by at least kPitFall_m less rounding.
/// Neighbours are the eight points around it. No point is lowered, and points of the border stay. O(n) on slopes, O(n
/// log n) in pits. Sources: Barnes, Lehman, Mulla, "Priority-flood", Computers & Geosciences 62, 2014; Zhou, Sun, Fu,
/// "An efficient variant of the priority-flood algorithm", Computers & Geosciences 90, 2016.
void fill_pits(Lattice& lattice);

}  // namespace citykiln::invent
