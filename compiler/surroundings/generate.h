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

/// The ground of the tiles on their border.
struct BorderGround {
  double height_m = 0;
  bool is_sea = false;
};

/// What the mesh is generated for.
struct Neighbourhood {
  bool is_curved = true;  ///< Whether the land follows the Earth's curve; else it is flat, as before it is bent.
  Box2 region;            ///< The extent; beyond it the land follows the Earth's curve.
  std::function<bool(Vec2)> is_in_tile;         ///< Whether a tile covers a cell of the grid, by its middle.
  std::function<BorderGround(Vec2)> on_border;  ///< Of the tiles, at places on their border.
  std::function<materials::SurfaceMaterial(Vec3, Vec3)> land_at;  ///< By place and unit normal.
};

/// Vertices on the border of tiles are at most so far apart; skirts are so deep: graded ground beside a road is up to a
/// few metres off the terrain.
inline constexpr double kBorderStep_m = 16, kSkirt_m = 12;

/// The surface of all cells that no tile covers: one mesh for each material, with normals and a tint a vertex. Sea
/// where all corners of a triangle are sea; else land. Positions are multiples of 2^-7 m. Same bytes on every CPU.
///
/// Guarantees: no gap between two cells; on the border of tiles the heights of on_border(). O(n).
/// @param around  Not empty; its lines include the borders of tiles.
std::vector<materials::MaterialMesh> generate(const Surroundings& around, const Neighbourhood& neighbourhood);

}  // namespace citykiln::surroundings
