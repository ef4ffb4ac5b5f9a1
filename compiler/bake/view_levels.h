// Chooses the tolerance of each part of a scene for one viewpoint: fine nearby, coarse far away, so that no error in
// the picture is longer than a given number of pixels.
//
//     eye ·------- distance ------->| error      pixels = error / distance · focal length
//
// Objects may be coarser if the picture shows neither them nor their shadow (Sight).
//
// A level is a number n that stands for the tolerance 2^n · View::finest_m. Each cell, a 128 m square of ground, has
// one level. The side between two cells has the smaller of their tolerances, so that they meet vertex for vertex like
// cells of one tolerance. If only one of them has Detail::kRoadSurfaces, their heights differ, so both have skirts
// (vertical strips below the side).
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "compiler/bake/bounds.h"
#include "compiler/bake/ground/ground_cells.h"
#include "compiler/scene/scene.h"

namespace citykiln::bake {

/// The region that one picture shows, as a pyramid, and the region whose shadows may fall there. Objects outside both
/// can only affect scattered light and reflections, so they may be coarser.
struct Sight {
  struct Plane {
    Vec3 normal;  ///< Unit length, pointing out of the pyramid.
    double offset_m = 0;
  };
  std::array<Plane, 4> sides;      ///< Sides of the pyramid that the picture shows.
  Vec3 to_sun{};                   ///< Unit length; zero: there are no sharp shadows.
  double lowest_m = 0;             ///< Lowest height that receives shadows.
  double longest_shadow_m = 3000;  ///< Largest length of a shadow, along the light.
  double unseen_rad = 0;           ///< Allowed error of objects that are not seen: an angle from the eye, >= 0.
};

/// True if the bounds or their shadow may be in the picture.
bool is_seen(const Sight& sight, const Bounds& bounds);

/// One or several viewpoints, and the error that is allowed there in all directions.
struct View {
  Vec3 eye;                         ///< Plane metres.
  double focal_px = 0;              ///< Focal length in pixels (focal_length_px). > 0.
  double pixel_error = 1;           ///< The largest allowed error in the picture, in pixels. > 0.
  double finest_m = 0.02;           ///< The smallest tolerance, for objects near the eye. > 0.
  std::vector<Bounds> more_eyes{};  ///< Boxes that contain further eyes. Distances count from the nearest eye, which
                                    ///< may be anywhere in its box.
  std::optional<Sight> sight{};     ///< For a single picture: objects that it does not show may be coarser.
};

/// The distance from the nearest eye to the bounds; 0 if an eye may be inside.
double distance_m(const View& view, const Bounds& bounds);

/// The focal length of a picture in pixels: the length in the middle of the picture of an object whose length equals
/// its distance. Rounded to 2^-10 pixels.
double focal_length_px(int height_px, double vertical_fov_deg);

/// The tolerance of a level: 2^level · View::finest_m.
double tolerance_m_of(const View& view, int level);

/// The coarsest level whose error, at the nearest point of the bounds, is at most View::pixel_error. For bounds that
/// View::sight does not show, an error of Sight::unseen_rad is allowed, if that is larger. 0 if no level is fine
/// enough.
int level_for(const View& view, const Bounds& bounds);

/// An upper bound of the length of an error in the picture, in pixels. 0 for bounds so near that they are baked at the
/// finest tolerance in any case.
/// @param bounds  Bounds of the object that has the error.
double pixels_of(const View& view, double error_m, const Bounds& bounds);

/// The levels of a scene's cells for a viewpoint. A cell is a 128 m square of ground.
struct ViewLevels {
  static constexpr int kNoLevel = std::numeric_limits<int>::max();

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
/// enough for every object of the tile.
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
