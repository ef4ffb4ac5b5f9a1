// Plants in grids of cells about a spot, as RPForest (Rudzki 2020) places them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "compiler/invent/invented_map.h"
#include "compiler/invent/terrain.h"

namespace citykiln::invent {

/// A place for a viewer.
struct Spot {
  double height_m = 0;  ///< The height of the ground that is looked for.
  double edge_m = 0;    ///< The least distance from the border of the terrain; 0: the spot is the middle of the world.
};

/// A grid of cells about the spot; each cell has at most one plant.
struct Spawner {
  std::string species;
  double x_m = 0, y_m = 0;  ///< The middle of the grid, seen from the spot: to the east, to the north.
  int columns = 1, rows = 1;
  double cell_m = 3;
  double probability = 0.8;  ///< How likely a cell has a plant.
  double jitter = 0.8;       ///< The share of a cell, about its middle, in which the plant stands.
  double height_m = 2;       ///< The height of a plant, times a number between these two:
  double low_scale = 0.75, high_scale = 1.25;
};

/// Returns the lattice point with the least sum of the difference to the spot's height and the weighted unevenness of
/// the ground, at least edge_m from the border; the middle of the world if edge_m is 0. O(n).
Vec2 find_spot(const Terrain& terrain, const Spot& spot);

/// Adds the plants of all spawners as single trees with species and height.
void spawn_plants(const std::vector<Spawner>& spawners, Vec2 spot, std::uint64_t seed, InventedMap& map);

}  // namespace citykiln::invent
