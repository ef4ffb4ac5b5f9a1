// Generates the mesh of the land and sea around the tiles of a scene.
//
//     ──┬───┬──         a cell beside a tile is a fan about its middle: on the tile's border it has a vertex every
//       │╲ ╱│           16 m, at the height of the tile's ground, and a skirt hangs down there
//     ──┤ × ├──
//       │╱│╲│
//     ▒▒▒▒▒▒▒▒▒ tile
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "compiler/map/land_cover_class.h"
#include "compiler/materials/material_mesh.h"
#include "compiler/surroundings/cells.h"
#include "compiler/surroundings/recipe.h"

namespace citykiln::surroundings {

/// The ground of a tile at a place on its border.
struct BorderGround {
  double height_m = 0;
  Cover cover{};  ///< Water of the map is open water here.
};

/// The land cover of a cell.
struct Patch {
  map::LandCoverClass cover{};
  std::array<double, 3> tint = {1, 1, 1};  ///< A factor of the class's linear colour, such as a field's.
  double raised_m = 0;                     ///< The height of the canopy of a wood; 0: none.
  auto operator<=>(const Patch&) const = default;
};

/// The extent, its tiles and the look of the land around them. Places are plane metres; heights are above sea level.
struct Neighbourhood {
  bool is_curved = true;       ///< True: land is lowered by the Earth's curvature. False: flat, to be bent afterwards.
  Box2 extent;                 ///< The extent; land beyond it is lowered.
  std::int32_t finest_m = 32;  ///< The side of the cells beside tiles (CellSizes).
  std::function<double(const Box2&)> away_m;    ///< The distance of a box from the tiles; 0 where they touch.
  std::function<bool(Vec2)> is_in_tile;         ///< True if a tile covers a place that is on no tile's border.
  std::function<BorderGround(Vec2)> on_border;  ///< The ground of the tiles at a place on their border.
  std::function<double(Vec2)> height_m_at;      ///< The height of the land elsewhere.
  std::function<Patch(const Cell&)> patch_of;   ///< The land cover of a cell.
  /// The land cover of the tiles at a place on their border; empty where it does not go on, or if the function is.
  std::function<std::optional<Patch>(Vec2)> patch_on_border;
  std::function<materials::Material(const Patch&, Vec3, Vec3)> material_at;  ///< By middle and unit normal of a face.
  /// The tint of a material at a vertex, with its place and unit normal.
  std::function<materials::Tint(const Patch&, materials::Material, Vec3, Vec3)> tint_at;
};

/// The largest distance between vertices on the border of tiles, and the depth of the skirt there. The skirt
/// hides differences of a few metres between the ground graded for roads and the terrain.
inline constexpr double kBorderStep_m = 16, kSkirt_m = 12;

/// The surface of the land and sea around the tiles.
class AroundSurface {
 public:
  /// @param around  Not empty. Both must outlive this object.
  AroundSurface(const Surroundings& around, const Neighbourhood& neighbourhood);
  ~AroundSurface();

  /// Returns the surface of all cells that no tile covers: one mesh for each material, with normals and tints per
  /// vertex. A triangle is sea or lake if all its corners are, else it has the material of its cell. The tint of a
  /// vertex is the mean of the cells about it, so that squares do not show; on the border it is that of the tile. Cells
  /// with a canopy are raised by its height, which begins at 0 at the edge of the wood. Positions are multiples of 2^-7
  /// m. Same bytes on every CPU.
  ///
  /// Guarantees: no gap between two cells; on the border of tiles the heights of on_border(). O(n log n) for n cells.
  std::vector<materials::MaterialMesh> meshes() const;
  /// Returns the height of the ground, canopies left out, in the frame of the mesh; empty in tiles and beyond the end.
  std::optional<double> height_m_at(Vec2 place) const;
  /// Returns the patch of the cell at a place; null in tiles and beyond the end.
  const Patch* patch_at(Vec2 place) const;
  /// The largest vertical distance of a vertex of the grid from the surface, rounded up to whole metres; vertices in
  /// tiles, and within 256 m of them, are not counted.
  double distance_from_grid_m() const;

 private:
  struct Sheet;
  const Surroundings& around_;
  const Neighbourhood& neighbourhood_;
  std::unique_ptr<const Sheet> sheet_;
};

}  // namespace citykiln::surroundings
