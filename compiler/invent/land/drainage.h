// Where the water of each point of a lattice flows, and how much land drains through it.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/invent/land/lattice.h"

namespace citykiln::invent {

/// The drainage of a lattice. Points are numbered by Lattice::index(), row by row from the south-west.
struct Drainage {
  /// By point: the one of its eight neighbours in the direction of steepest descent; the point itself on the border.
  std::vector<std::uint32_t> receiver;
  std::vector<std::uint32_t> order;  ///< All points; each one after its receiver.
  std::vector<double> area_m2;       ///< By point: the land that drains through it, its own square included.
};

/// Returns the drainage of a lattice without pits (fill_pits.h). A pit, which has no lower neighbour,
/// would be its own receiver. O(n). Source: Braun,
/// Willett, "A very efficient O(n), implicit and parallel method to solve the stream power equation", Geomorphology
/// 180-181, 2013.
Drainage drain(const Lattice& lattice);

}  // namespace citykiln::invent
