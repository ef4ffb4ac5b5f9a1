// Bakes the ground cells of a tile one by one for a viewpoint, for programs that generate what they need.
//
//     prepare_cells()                what is made as a whole: graded terrain, placed plants, markings; objects by cell
//       └ bake_cell(tile, cell)      the cell's ground, and the objects whose bounds' centre lies in the cell
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "compiler/bake/baked_cell.h"
#include "compiler/bake/bounds.h"
#include "compiler/bake/view_levels.h"

namespace citykiln::bake {

/// A tile whose cells can be baked. Immutable.
struct CellTile;

/// Prepares a tile. Refers to header, chunk and view, which must outlive the result.
/// Cost: about a quarter of baking the tile.
std::shared_ptr<const CellTile> prepare_cells(const scene::Header& header, const scene::Chunk& chunk,
                                              const ViewLevels& view, std::shared_ptr<const PrototypeCache> prototypes);

/// An estimate of the memory of a prepared tile: its arrays, without the recipes that it refers to.
std::size_t bytes_of(const CellTile& tile);

/// Bakes one cell, by its index in cells_of(). All cells of a tile together have the triangles and the instances of
/// bake() for the view, each at the same level. Objects whose centre lies in no cell of the tile are in the nearest
/// one. Thread-safe. Total. Cost: what the cell holds.
BakedCell bake_cell(const CellTile& tile, std::size_t cell);

/// Returns bounds of what each cell bakes, in the order of cells_of(), from the recipes alone. They hold plants of any
/// height where plants may stand, and lamps. O(recipes).
std::vector<Bounds> cell_bounds(const scene::Header& header, const scene::Chunk& chunk, const ViewLevels& view);

/// The cell of a place: by index in cells_of(); places outside of the tile have the nearest.
std::size_t cell_at(const Box2& tile, Vec2 place);

}  // namespace citykiln::bake
