// Bakes the cells of a tile (128 m squares of ground with their objects) one by one for a viewpoint, for programs that
// generate only the cells that they need.
//
//     prepare_cells()                data of the whole tile: graded terrain, placed plants, markings; objects by cell
//       └ bake_cell(tile, cell)      the cell's ground, and the objects whose bounds' centre lies in the cell
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "compiler/bake/baked_cell.h"
#include "compiler/bake/bounds.h"
#include "compiler/bake/view/view_levels.h"

namespace citykiln::bake {

/// A tile whose cells can be baked. Immutable.
struct CellTile;

/// Prepares a tile. Cost: about a quarter of baking the tile.
/// @param header, chunk, view  Must outlive the result, which refers to them.
/// @param prototypes           Shared meshes of plants.
std::shared_ptr<const CellTile> prepare_cells(const scene::Header& header, const scene::Chunk& chunk,
                                              const ViewLevels& view, std::shared_ptr<const PrototypeCache> prototypes);

/// An estimate of the memory of a prepared tile: its arrays, without the recipes that it refers to.
std::size_t bytes_of(const CellTile& tile);

/// Bakes one cell. All cells of a tile together have the triangles and instances of bake() for the same view. An object
/// belongs to the cell that contains the centre of its bounds, else to the nearest cell. Thread-safe. Cannot fail.
/// Cost: linear in the cell's objects.
/// @param cell  Index in cells_of().
BakedCell bake_cell(const CellTile& tile, std::size_t cell);

/// Returns bounds of each cell's meshes and instances, in the order of cells_of(), from the recipes only. They allow
/// for plants of any height wherever plants may stand, and for lamps. O(recipes).
std::vector<Bounds> cell_bounds(const scene::Header& header, const scene::Chunk& chunk, const ViewLevels& view);

/// The cell that contains a place, as an index in cells_of(); for places outside of the tile the nearest cell.
std::size_t cell_at(const Box2& tile, Vec2 place);

}  // namespace citykiln::bake
