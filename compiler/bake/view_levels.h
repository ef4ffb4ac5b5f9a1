// How fine each place of a scene is made for one eye: near finely, far coarsely, so that no error is longer on the
// picture than so many pixels.
//
//     eye ·------- distance ------->| error      pixels = error / distance · focal length
//
// The ground has a tolerance a cell. On the side between two cells the smaller of theirs holds for both, so they meet
// vertex for vertex as cells of one tolerance do. Only where one of them sees kerbs and lines and the other does not
// (Detail::kRoadSurfaces) their heights differ: there skirts hang from both.
#pragma once

#include <vector>

#include "compiler/bake/bounds.h"
#include "compiler/bake/ground_cells.h"
#include "compiler/scene/scene.h"

namespace citykiln::bake {

/// An eye, whichever way it looks.
struct View {
  Vec3 eye;                ///< Plane metres.
  double focal_px = 0;     ///< What is as long as it is far off is so many pixels long in the picture's middle. > 0.
  double pixel_error = 1;  ///< > 0.
  double finest_m = 0.02;  ///< Nothing is made finer than this, however near. > 0.
};

/// The focal length of a picture in pixels: a thing as long as it is far away is this many pixels long in the middle of
/// the picture. Rounded to 2^-10 pixels.
double focal_length_px(int height_px, double vertical_fov_deg);

/// The tolerance of what lies within the bounds: the largest power of two times the finest whose error is not longer
/// than the view's pixels at the nearest place; the finest where even that is.
double tolerance_m_for(const View& view, const Bounds& bounds);

/// How long an error is on the picture, at most. Of what is so near that it is made at the finest whatever its error,
/// nothing: 0.
double pixels_of(const View& view, double error_m, const Bounds& bounds);

struct ViewLevels {
  View view;
  Box2 region;  ///< Of the scene.
  int columns = 0, rows = 0;
  std::vector<double>
      cells_m;          ///< The tolerance of each cell of the region, by column, then row; infinity: of no tile.
  double finest_m = 0;  ///< Of these.
};

/// @param scene  All of it: what lies beside a tile counts. Cells are as high as the terrain, 16 m more and less, as
///               roads may be carved into it.
/// O(heights).
ViewLevels levels_for(const scene::Scene& scene, const View& view);

/// A cell as a view sees it.
struct ViewCell {
  CellLevel level;
  Box2 skirt;          ///< Skirts hang from what lies in its sides.
  double skirt_m = 0;  ///< How deep.
};

/// Those of a tile, in the order of cells_of.
std::vector<ViewCell> cells_of(const ViewLevels& levels, const Box2& tile);

/// Cells that see roads alike: with kerbs and lines, or without.
struct ViewZone {
  std::vector<CellLevel> cells;
  double roads_m = 0;  ///< At what tolerance to ask for the cover and the graded terrain of all of them.
};

/// Those of a tile that have cells, the finer one first.
std::vector<ViewZone> zones_of(const ViewLevels& levels, const Box2& tile);

/// The tolerances of a tile's parts, rising: those of its cells, and one that is fine enough for whatever stands there.
std::vector<double> tolerances_of(const ViewLevels& levels, const scene::Header& header, const scene::Chunk& chunk);

/// What of a tile is made at one of its tolerances: all of its parts together are the tile.
struct TilePart {
  const ViewLevels& levels;
  const std::vector<double>& tolerances_m;  ///< Of the tile.
  double tolerance_m;                       ///< Of the part.
};

/// True for the part with the largest tolerance that is fine enough. Each thing is in exactly one part.
bool is_in(const TilePart& part, const Bounds& bounds);

/// At what tolerance a part asks for roads and their sheets: all that sees kerbs and lines must see the same ones.
double roads_tolerance_m(const ViewLevels& levels, double tolerance_m);

}  // namespace citykiln::bake
