// The tolerance of each part of a scene for one viewpoint: fine nearby, coarse far away, so that no error in the
// picture is longer than a given number of pixels.
//
//     eye ·------- distance ------->| error      pixels = error / distance · focal length
//
// Objects that no pixel shows directly, nor their shadow, may be coarser (Sight).
//
// Level n has the tolerance 2^n · View::finest_m. The ground has a level per cell. The side between two cells has the
// smaller of their tolerances, so that they meet vertex for vertex like cells of one tolerance. If only one of them has
// Detail::kRoadSurfaces, their heights differ, so both have skirts.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "compiler/bake/bounds.h"
#include "compiler/bake/ground/ground_cells.h"
#include "compiler/scene/scene.h"

namespace citykiln::bake {

/// The part of a scene that one picture shows, and the part whose shadows may fall there. Only scattered light and
/// reflections reach the rest.
struct Sight {
  struct Plane {
    Vec3 normal;  ///< Unit length, pointing out of the pyramid.
    double offset_m = 0;
  };
  std::array<Plane, 4> sides;      ///< Sides of the pyramid that the picture shows.
  Vec3 to_sun{};                   ///< Unit length; zero: there are no sharp shadows.
  double lowest_m = 0;             ///< Lowest height that receives shadows.
  double longest_shadow_m = 3000;  ///< Largest length of a shadow, along the light.
  double unseen_rad = 0;           ///< Allowed angle of an error that is not seen, from the eye. >= 0.
};

/// True if the bounds or their shadow may be in the picture.
bool is_seen(const Sight& sight, const Bounds& bounds);

/// One or several viewpoints, and the error that is allowed there in all directions.
struct View {
  Vec3 eye;                         ///< Plane metres.
  double focal_px = 0;              ///< Focal length in pixels (focal_length_px). > 0.
  double pixel_error = 1;           ///< > 0.
  double finest_m = 0.02;           ///< The smallest tolerance, for objects near the eye. > 0.
  std::vector<Bounds> more_eyes{};  ///< Boxes of further eyes. The nearest eye counts, at any place in its box.
  std::optional<Sight> sight{};     ///< For a single picture: objects that it does not show may be coarser.
};

/// The distance from the nearest eye to the bounds; 0 if an eye may be inside.
double distance_m(const View& view, const Bounds& bounds);

/// The focal length of a picture in pixels: the length in the middle of the picture of an object whose length equals
/// its distance. Rounded to 2^-10 pixels.
double focal_length_px(int height_px, double vertical_fov_deg);

/// The tolerance of a level.
double tolerance_m_of(const View& view, int level);

/// The coarsest level whose error at the nearest point of the bounds is at most the view's pixel error, or, for bounds
/// that the view does not show, at most Sight::unseen_rad if that is larger. 0 if no level is fine enough.
int level_for(const View& view, const Bounds& bounds);

/// An upper bound of an error's length in the picture, in pixels. 0 for bounds so near that they are baked at the
/// finest tolerance in any case.
double pixels_of(const View& view, double error_m, const Bounds& bounds);

/// The levels of a scene's cells for a view.
struct ViewLevels {
  static constexpr int kNoLevel = std::numeric_limits<int>::max();

  View view;
  Box2 extent;  ///< The extent of the scene.
  int columns = 0, rows = 0;
  std::vector<int> cells{};  ///< Level of each cell of the extent, by column, then row; kNoLevel if no tile covers it.
  int finest = kNoLevel;     ///< The smallest of these.
};

/// Returns the levels of all cells. The bounds of a cell are those of its terrain, widened by 16 m up and down, since
/// roads may be cut into the terrain or raised above it.
/// @param scene  The whole scene, since the cells beside a tile count.
/// O(heights).
ViewLevels levels_for(const scene::Scene& scene, const View& view);

/// A cell at its level.
struct ViewCell {
  CellLevel level;
  int number = 0;      ///< Number of the level.
  Box2 skirt;          ///< Edges that lie in the sides of this box have skirts.
  double skirt_m = 0;  ///< Depth of the skirts.
};

/// The cells of a tile with their levels, in the order of cells_of(tile).
std::vector<ViewCell> cells_of(const ViewLevels& levels, const Box2& tile);

/// Cells that agree in Detail::kRoadSurfaces: all of them have it, or none.
struct ViewZone {
  std::vector<CellLevel> cells;
  double roads_m = 0;  ///< The tolerance of their land cover and graded terrain.
};

/// The one or two zones of a tile, the finer one first.
std::vector<ViewZone> zones_of(const ViewLevels& levels, const Box2& tile);

/// The levels of a tile's parts, ascending: those of its cells, and one that is fine enough for every object of the
/// tile.
std::vector<int> levels_of_parts(const ViewLevels& levels, const scene::Header& header, const scene::Chunk& chunk);

/// The index, among the ascending levels of a tile's parts, of the coarsest one that is at most `level`; 0 if there is
/// none.
std::size_t part_at(const std::vector<int>& of_tile, int level);

/// One part of a tile: its cells and objects of one level.
struct TilePart {
  const ViewLevels& levels;
  const std::vector<int>& of_tile;  ///< The levels of all parts, ascending.
  int level;                        ///< The level of this part.
};

/// True if an object is in the part. Each object is in exactly one part: the coarsest one that is fine enough.
bool is_in_part(const TilePart& part, const Bounds& bounds);

/// The tolerance of a level's roads and markings. All levels with Detail::kRoadSurfaces use that of the finest level,
/// so that they agree.
double roads_tolerance_m(const ViewLevels& levels, int level);

}  // namespace citykiln::bake
