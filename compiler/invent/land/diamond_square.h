// Fractal heights by midpoint displacement on a square lattice.
#pragma once

#include <cstdint>
#include <vector>

namespace citykiln::invent {

/// The parameters of RPForest's terrain (Rudzki 2020).
struct DiamondSquare {
  int power = 8;                ///< The lattice has 2^power cells a side, 1 to 12.
  double initial_height_m = 0;  ///< The mean height of the four corners.
  double corner_spread_m = 0;   ///< Corners are between -corner_spread_m and corner_spread_m from the initial height.
  double spread_m = 100;        ///< The first displacements are between -spread_m and spread_m.
  double reduction = 0.5;       ///< Each level's spread is that of the level before times this, 0 to 1.
};

/// Returns (2^power + 1)² heights, row by row from the south-west corner. Each level sets the middles of squares to the
/// mean of their corners, then the middles of edges to the mean of the points beside them, each plus a displacement.
///
/// Guarantees: corners are within corner_spread_m of the initial height; all heights are within that and twice the sum
/// of all levels' spreads of it. RPForest's InitHeight is corner_spread_m, with an initial height of 0.
/// Source: Fournier, Fussell, Carpenter, "Computer Rendering of Stochastic Models", CACM 25, 1982.
std::vector<double> diamond_square(const DiamondSquare& settings, std::uint64_t seed);

}  // namespace citykiln::invent
