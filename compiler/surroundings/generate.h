// Generates the mesh of the land and sea around the tiles of a scene.
//
//     ──┬───┬──         a cell beside a tile is a fan about its middle: on the tile's border it has a vertex every
//       │╲ ╱│           16 m, at the height of the tile's ground, and a skirt hangs down there
//     ──┤ × ├──
//       │╱│╲│
//     ▒▒▒▒▒▒▒▒▒ tile
#pragma once

#include <functional>
#include <vector>

#include "compiler/materials/material_mesh.h"
#include "compiler/surroundings/recipe.h"

namespace citykiln::surroundings {

/// The ground of a tile at a place on its border.
struct BorderGround {
  double height_m = 0;
  bool is_sea = false;
};

/// The extent, its tiles and the materials of the land around them.
struct Neighbourhood {
  bool is_curved = true;  ///< True: land is lowered by the Earth's curvature. False: flat, to be bent afterwards.
  Box2 extent;            ///< The extent; land beyond it is lowered.
  std::function<bool(Vec2)> is_in_tile;         ///< True if a tile covers the cell of the grid with this centre.
  std::function<BorderGround(Vec2)> on_border;  ///< The ground of the tiles at a place on their border.
  std::function<materials::SurfaceMaterial(Vec3, Vec3)> land_at;  ///< The material of land by place and unit normal.
};

/// The largest distance between vertices on the border of tiles, and the depth of the skirt there, which hides that
/// graded ground beside a road is up to a few metres off the terrain.
inline constexpr double kBorderStep_m = 16, kSkirt_m = 12;

/// Returns the surface of all cells that no tile covers: one mesh for each material, with normals and tints per vertex.
/// A triangle is sea if all its corners are sea, else land. Positions are multiples of 2^-7 m. Same bytes on every CPU.
///
/// Guarantees: no gap between two cells; on the border of tiles the heights of on_border(). O(n).
/// @param around  Not empty; its lines include the borders of tiles.
std::vector<materials::MaterialMesh> generate(const Surroundings& around, const Neighbourhood& neighbourhood);

}  // namespace citykiln::surroundings
