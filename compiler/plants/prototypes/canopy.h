// A wood from very far: where trees stand closed, one surface over their crowns instead of a body each.
//
//            _   __
//          _/ \_/  \_         corners of a lattice of the plane, as high as a tree would be there (crown_mix.h);
//   |  |__/          \__|     on the ground where the canopy ends: before that slope trees stay trees
//   ---'----------------'---
#pragma once

#include <vector>

#include "compiler/materials/material_mesh.h"
#include "compiler/plants/generate.h"
#include "compiler/plants/season.h"

namespace citykiln::plants {

/// Width of its cells. Tiles' sides are multiples of it, and two cells beyond them are known.
inline constexpr double kCanopyCell_m = 16;

struct Canopy {
  std::vector<materials::MaterialMesh> meshes;  ///< One a wood, plane metres, with normals and tints.
  double error_m = 0;                           ///< Stated: of the trees that it stands for.
  Box2 box{};
  int columns = 0;             ///< Of cells.
  std::vector<bool> is_whole;  ///< By cell, row by row from the south-west: at each of its corners it is in the air.
  std::vector<double> tops_m;  ///< By corner, likewise: heights of those of whole cells.
};

/// The canopy in the box, whose sides are multiples of its cells'. A cell is closed where woods that are not thinned
/// cover all of it but for a path, no lane crosses it, and its trees are not too low to see. Corners of closed cells
/// alone are in the air.
///
/// Guarantees: places, normals and tints of corners are functions of the place: those on a side of the box are the
/// neighbour's too. Below the tolerance that it is from, empty. Cost: O(cells · samples).
Canopy make_canopy(std::span<const Wood> woods, std::span<const PowerLineCorridor> corridors,
                   const PlacingContext& land, double tolerance_m, Month month);

/// Takes those trees of the woods that stand in whole cells out of what is placed, and states how far the canopy is
/// from them: from their tops, and from the middle of trunks, which have the ground below and the canopy above.
void remove_trees_below(Canopy& canopy, std::span<const Wood> woods, PlacedPlants& placed);

}  // namespace citykiln::plants
