// Erosion of a lattice by running water and by creep.
#pragma once

#include <vector>

#include "compiler/invent/land/lattice.h"

namespace citykiln::invent {

struct Erosion {
  int steps = 8;
  double strength = 0.015;  ///< K times the length of a step in time, for area in m² and slope as a ratio.
  double creep = 0.1;       ///< The share of the difference to the mean of its neighbours that a point loses a step.
};

/// Lowers the land by the stream power law, dh/dt = -K √area slope, solved implicitly from the outlets upstream, so
/// that every strength is stable; then by creep. Pits are filled before each step and at the end.
///
/// @param is_fixed  Points that erosion does not lower, such as lakes with their outlets; empty for none. Filling
///                  pits may raise them. The border is not lowered either.
/// Guarantee: the result has no pits.
/// Source: Braun and Willett 2013 (drainage.h).
void erode(Lattice& lattice, const Erosion& settings, const std::vector<bool>& is_fixed);

}  // namespace citykiln::invent
