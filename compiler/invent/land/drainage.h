// Where the water of each point of a lattice flows, and how much land drains through it.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/invent/land/lattice.h"

namespace citykiln::invent {

struct Drainage {
  std::vector<std::uint32_t> receiver;  ///< The neighbour of steepest descent; the point itself on the border.
  std::vector<std::uint32_t> order;     ///< All points; each one after its receiver.
  std::vector<double> area_m2;          ///< The land that drains through the point, its own square included.
};

/// Returns the drainage of a lattice without pits (fill_pits.h). A pit would keep its water. O(n). Source: Braun,
/// Willett, "A very efficient O(n), implicit and parallel method to solve the stream power equation", Geomorphology
/// 180-181, 2013.
Drainage drain(const Lattice& lattice);

}  // namespace citykiln::invent
