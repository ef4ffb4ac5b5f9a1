// The tolerance of each part of a scene for one viewpoint: fine nearby, coarse far away, so that no error in the
// picture is longer than a given number of pixels.
//
//     eye ·------- distance ------->| error      pixels = error / distance · focal length
//
// What no pixel shows directly, nor a shadow, may be coarser (Sight).
//
// Level n has the tolerance 2^n · View::finest_m. The ground has a level per cell. The side between two cells has the
// smaller of their tolerances, so that they meet vertex for vertex as cells of one tolerance do. Only where one of them
// has Detail::kRoadSurfaces and the other does not their heights differ: there skirts hang from both.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "compiler/bake/bounds.h"
#include "compiler/bake/ground_cells.h"
#include "compiler/scene/scene.h"

namespace citykiln::bake {

/// The part of a scene that one picture shows, and the part whose shadows may fall there. The rest is met by scattered
/// light and in reflections alone.
struct Sight {
  struct Plane {
    Vec3 normal;  ///< Unit, away from the picture.
    double offset_m = 0;
  };
  std::array<Plane, 4> sides;      ///< Of the pyramid that the picture shows.
  Vec3 to_sun{};                   ///< Unit; zero: nothing throws a sharp shadow.
  double lowest_m = 0;             ///< Nothing that receives shadows is lower.
  double longest_shadow_m = 3000;  ///< Along the light.
  double unseen_rad = 0;           ///< Largest angle of an error outside, seen from the eye. >= 0.
};

/// False only if neither the bounds nor their shadow are in the picture.
bool is_seen(const Sight& sight, const Bounds& bounds);

/// A viewpoint, or several, whatever the direction of view.
struct View {
  Vec3 eye;                         ///< Plane metres.
  double focal_px = 0;              ///< Focal length in pixels (focal_length_px). > 0.
  double pixel_error = 1;           ///< > 0.
  double finest_m = 0.02;           ///< The smallest tolerance, however near the eye. > 0.
  std::vector<Bounds> more_eyes{};  ///< Boxes of further eyes: the nearest eye counts, wherever it is in its box.
  std::optional<Sight> sight{};     ///< Of a single picture: what it does not show may be coarser.
};

/// The distance from the nearest eye to the bounds; 0 where one may be inside.
double distance_m(const View& view, const Bounds& bounds);

/// The focal length of a picture in pixels: an object as long as it is far away is this many pixels long in the middle
/// of the picture. Rounded to 2^-10 pixels.
double focal_length_px(int height_px, double vertical_fov_deg);

/// The tolerance of a level.
double tolerance_m_of(const View& view, int level);

/// The coarsest level whose error is not longer than the view's pixel error at the nearest point of the bounds, or,
/// where the view's sight does not reach, than its larger angle; 0 where no level is fine enough.
int level_for(const View& view, const Bounds& bounds);

/// An upper bound of an error's length in the picture. 0 for bounds so near that they are baked at the finest tolerance
/// whatever their error.
double pixels_of(const View& view, double error_m, const Bounds& bounds);

/// The levels of a scene's cells for a view.
struct ViewLevels {
  static constexpr int kNoLevel = std::numeric_limits<int>::max();

  View view;
  Box2 region;  ///< Of the scene.
  int columns = 0, rows = 0;
  std::vector<int>
      cells{};            ///< Level of each cell of the region, by column, then row; kNoLevel where there is no tile.
  int finest = kNoLevel;  ///< The smallest of these.
};

/// Returns the levels of all cells. The bounds of a cell are its terrain, 16 m more and less, since roads may be cut
/// into it or raised above it.
/// @param scene  The whole scene: the cells beside a tile count.
/// O(heights).
ViewLevels levels_for(const scene::Scene& scene, const View& view);

/// A cell at its level.
struct ViewCell {
  CellLevel level;
  int number = 0;      ///< Of the level.
  Box2 skirt;          ///< Skirts hang from the edges that lie in its sides.
  double skirt_m = 0;  ///< Their depth.
};

/// The cells of a tile, in the order of cells_of.
std::vector<ViewCell> cells_of(const ViewLevels& levels, const Box2& tile);

/// Cells that all have Detail::kRoadSurfaces, or all do not.
struct ViewZone {
  std::vector<CellLevel> cells;
  double roads_m = 0;  ///< The tolerance at which their land cover and graded terrain are made.
};

/// The one or two zones of a tile, the finer one first.
std::vector<ViewZone> zones_of(const ViewLevels& levels, const Box2& tile);

/// The levels of a tile's parts, rising: those of its cells, and one that is fine enough for every object of the tile.
std::vector<int> levels_of_parts(const ViewLevels& levels, const scene::Header& header, const scene::Chunk& chunk);

/// The index among the levels of a tile's parts, rising, of the coarsest one that is at most `level`; 0 where none is.
std::size_t part_at(const std::vector<int>& of_tile, int level);

/// One part of a tile: what is baked at one of its levels.
struct TilePart {
  const ViewLevels& levels;
  const std::vector<int>& of_tile;  ///< The levels of all parts, rising.
  int level;                        ///< The part's.
};

/// Whether an object is in the part: in the coarsest one that is fine enough. Each object is in exactly one part.
bool is_in_part(const TilePart& part, const Bounds& bounds);

/// The tolerance at which a level's roads and markings are made: that of the finest level for all levels with
/// Detail::kRoadSurfaces, so that they agree.
double roads_tolerance_m(const ViewLevels& levels, int level);

}  // namespace citykiln::bake
