// The levels of the parts of a scene for one viewpoint: those of its cells, and the parts of a tile that have one
// level.
//
// Each cell, a 128 m square of ground, has one level (view.h). The side between two cells has the smaller of their
// tolerances, so that they meet vertex for vertex like cells of one tolerance. If only one of them has
// Detail::kRoadSurfaces, their heights differ, so both have skirts (vertical strips below the side).
#pragma once

#include <vector>

#include "compiler/bake/ground/ground_cells.h"
#include "compiler/bake/view/view.h"
#include "compiler/scene/scene.h"

namespace citykiln::bake {

/// The levels of a scene's cells for a viewpoint. A cell is a 128 m square of ground.
struct ViewLevels {
  View view;
  Box2 extent;  ///< The extent of the scene.
  int columns = 0, rows = 0;
  std::vector<int> cells{};  ///< Level of each cell of the extent, column by column from the south-west; kNoLevel if no
                             ///< tile covers it.
  int finest = kNoLevel;     ///< The smallest of these.
};

/// Returns the levels of all cells. The bounds of a cell contain its terrain and 16 m below and above it, since roads
/// may be cut into the terrain or raised above it.
/// @param scene  The whole scene, since a cell's sides depend on the cells beside it.
/// O(heights).
ViewLevels levels_for(const scene::Scene& scene, const View& view);

/// A cell with its tolerances and skirts (vertical strips below its border that hide gaps).
struct ViewCell {
  CellLevel level;
  int number = 0;      ///< The level.
  Box2 skirt;          ///< Ground edges that lie in a side of this box get a skirt.
  double skirt_m = 0;  ///< Depth of the skirts.
};

/// The cells of a tile with their levels, in the order of cells_of(tile).
std::vector<ViewCell> cells_of(const ViewLevels& levels, const Box2& tile);

/// The cells of a tile that have Detail::kRoadSurfaces, or those that do not have it.
struct ViewZone {
  std::vector<CellLevel> cells;
  double roads_m = 0;  ///< The tolerance for the land cover and graded terrain of these cells.
};

/// The one or two zones of a tile, the finer one first.
std::vector<ViewZone> zones_of(const ViewLevels& levels, const Box2& tile);

/// Returns the levels of the parts in which a tile is baked, ascending: the levels of its cells, and one that is fine
/// enough for every object of the tile. O(heights and objects of the chunk).
std::vector<int> levels_of_parts(const ViewLevels& levels, const scene::Header& header, const scene::Chunk& chunk);

/// Returns the index, among the levels of a tile's parts, of the coarsest level that is at most `level`; 0 if there is
/// none.
/// @param of_tile  Result of levels_of_parts().
std::size_t part_at(const std::vector<int>& of_tile, int level);

/// One part of a tile for a viewpoint: the cells and objects of one level.
struct TilePart {
  const ViewLevels& levels;
  const std::vector<int>& of_tile;  ///< The levels of all parts, ascending.
  int level;                        ///< The level of this part.
};

/// True if an object with these bounds is in the part. Each object is in exactly one part: the coarsest one that is
/// fine enough.
bool is_in_part(const TilePart& part, const Bounds& bounds);

/// The tolerance of a level's roads and markings. All levels with Detail::kRoadSurfaces use the tolerance of the finest
/// level, so that neighbouring cells agree.
double roads_tolerance_m(const ViewLevels& levels, int level);

}  // namespace citykiln::bake
