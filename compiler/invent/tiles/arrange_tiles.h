// Arranges tiles on a grid such that neighbours have equal labels on their common side.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/invent/tiles/tile_set.h"

namespace citykiln::invent {

/// The size of a grid of tiles, and how noise begins it.
struct TileGridRequest {
  int columns = 0, rows = 0;
  std::uint64_t seed = 0;
  double fixed_share = 0.02;  ///< The share of cells that the noise fixes first.
  double noise_cells = 12;    ///< The size of the noise's features, in cells.
};

/// Tiles of a grid, row by row from the south-west corner.
struct TileGrid {
  int columns = 0, rows = 0;
  std::vector<std::uint8_t> tiles;  ///< Indices into TileSet::turned.
  std::size_t fixed = 0;            ///< Cells that were fixed first.
  std::size_t not_fixed = 0;        ///< Cells that could not be fixed, since they contradict earlier ones.
  std::size_t contradictions = 0;   ///< Cells for which no tile was left.
  std::size_t backtracks = 0;       ///< Decisions that were taken back.

  std::size_t road_parts = 0;  ///< Parts of the road network at first, and once they are connected.
  std::size_t road_parts_left = 0;

  const std::uint8_t& at(int column, int row) const { return tiles[static_cast<std::size_t>(row) * columns + column]; }
};

/// Fills a grid with tiles. Perlin noise fixes a few cells. The rest is filled by wave function collapse: the cell with
/// the fewest possible tiles is decided, weighted by its tiles and the noise, and impossible tiles are removed around
/// it until nothing changes. If no tile is left for a cell, the last decision is taken back; if this happens often,
/// more decisions are.
///
/// Guarantees: neighbours have equal labels on their common side; a function of the set and the request. Error: no
/// arrangement was found within 100,000 and 50 a cell backtracks, with all, half or none of the cells fixed first.
/// Cost: about 2 µs a cell. Sources: Wang, "Proving theorems by pattern recognition II", 1961; Gumin,
/// "WaveFunctionCollapse", 2016.
Result<TileGrid> arrange_tiles(const TileSet& set, const TileGridRequest& request);

}  // namespace citykiln::invent
