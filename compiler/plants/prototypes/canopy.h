// Canopies: at coarse levels a closed wood is one surface over its crowns, instead of a hull (a mesh of a few
// triangles) for each tree.
//
//            _   __
//          _/ \_/  \_         vertices of a lattice, as high as the trees there (canopy.cpp); on the ground where
//   |  |__/          \__|     the canopy ends, and trees keep their hulls
//   ---'----------------'---
#pragma once

#include <vector>

#include "compiler/materials/material_mesh.h"
#include "compiler/plants/placing/placing.h"
#include "compiler/plants/season.h"

namespace citykiln::plants {

/// The width of the widest cells. A tile's side is a multiple of it; land cover is known two cells beyond the tile.
inline constexpr double kWidestCanopyCell_m = 16;

/// Returns the width of a cell: the largest of 16, 8, 4 and 2 m that is at most 3.5 tolerances, but at least 2 m, so
/// that crowns keep their relief.
double canopy_cell_m(double tolerance_m);

/// The canopies of the woods in a box.
struct Canopy {
  std::vector<materials::MaterialMesh> meshes;  ///< Some per wood, plane metres, with normals and tints.
  double error_m = 0;  ///< The stated (not certified) error of the trees that remove_trees_below() removes.
  Box2 box{};
  double cell_m = kWidestCanopyCell_m;
  int columns = 0;             ///< The number of cells from west to east.
  std::vector<bool> is_whole;  ///< By cell, row by row from the south-west: true if all four vertices are raised, so
                               ///< that the canopy replaces the trees.
  /// By vertex, row by row from the south-west: z of a raised vertex in the plane, else 0.
  std::vector<double> tops_m;
};

/// Returns the canopy in a box. A cell is closed if dense woods cover it except for a path, no corridor crosses it, and
/// its trees are high enough to see. A vertex is raised if all four of its cells are closed.
///
/// @param context     Sides of its box are multiples of kWidestCanopyCell_m.
/// @param tolerance_m  Without Detail::kWoodCanopies the canopy is empty.
///
/// Guarantees: positions, normals and tints of vertices are functions of the position in plan, so neighbouring tiles
/// agree on their border. Cost: O(cells · samples).
Canopy make_canopy(std::span<const Wood> woods, std::span<const PowerLineCorridor> corridors,
                   const PlacingContext& context, double tolerance_m, Month month);

/// Removes the trees of woods that stand in cells of Canopy::is_whole. Sets canopy.error_m to the largest distance from
/// their tops to the canopy, but at least to half of their height, since the middle of a trunk lies between ground and
/// canopy.
void remove_trees_below(Canopy& canopy, std::span<const Wood> woods, PlacedPlants& placed);

}  // namespace citykiln::plants
