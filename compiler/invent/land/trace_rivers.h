// Rivers: the points of a lattice that drain enough land, as lines.
#pragma once

#include <vector>

#include "compiler/invent/land/drainage.h"
#include "compiler/invent/land/lattice.h"
#include "compiler/invent/land/terrain_settings.h"
#include "compiler/invent/terrain.h"

namespace citykiln::invent {

/// A river, and the height of its water at each point of its axis, falling downstream.
struct TracedRiver {
  River river;
  std::vector<double> levels_m;
};

/// Returns one river from each source and each confluence to the next confluence, standing water, or the border. Rivers
/// meet in equal points. Axes are smoothed between their ends, by less than a step of the lattice.
/// @param is_standing  Points in lakes and in the sea, which rivers enter by one point.
/// O(n).
std::vector<TracedRiver> trace_rivers(const Lattice& lattice, const Drainage& drainage, const TerrainSettings& settings,
                                      const std::vector<bool>& is_standing);

/// Lowers the points near rivers to the water's level, so that smoothed axes lie in a valley. Fixed points stay.
void lower_to_rivers(Lattice& lattice, const std::vector<TracedRiver>& rivers, const std::vector<bool>& is_fixed);

}  // namespace citykiln::invent
