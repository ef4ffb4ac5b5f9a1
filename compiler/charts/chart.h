// Charts of speed against accuracy: a table of series, written as CSV, and drawn as SVG by gnuplot.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/geometry/vec.h"
#include "compiler/scene/scene.h"
#include "compiler/source/raster.h"

namespace citykiln::charts {

struct Axis {
  std::string label;  ///< With its unit: "distance from the origin (km)".
  bool is_logarithmic = false;
};

struct Series {
  std::string name;
  std::vector<std::pair<double, double>> points;
  bool is_reference = false;  ///< Somebody else's figure: drawn as lone points.
};

struct Chart {
  std::string name;  ///< Of the files: "plane_length".
  std::string title;
  Axis x, y;
  std::vector<Series> series;
};

/// Writes NAME.csv (columns series, x, y) and NAME.svg into the folder. Errors: a folder that cannot be written;
/// gnuplot missing or unwilling, the CSV stays then.
Result<Done> write_chart(const Chart& chart, const std::string& folder);

/// What a chart may be told.
struct ChartRequest {
  std::vector<std::string> names;
  std::string folder;
  source::LonLatBox bbox;  ///< Of the terrain chart; all of the heightmap where empty.
  bool has_bbox = false;
  std::vector<std::string> rasters;  ///< As --dem gives them; the terrain chart draws the first.
  std::vector<std::string> maps;     ///< Of all charts but those of plane, terrain, plant and lsystem.
  std::optional<Vec3> eye;           ///< Of the view chart; else 100 m over the middle of the map.
  double lat_deg = 42.5;             ///< Of the plane chart's origin.
  double cell_m = 1024;              ///< Of the terrain chart.
  int threads = 0;
};

/// How far lengths and angles of the plane are off against the geodesic, over the distance from the origin, beside
/// other projections; time per point in their names.
Result<std::vector<Chart>> chart_plane(const ChartRequest& request);
/// The vertical error of the ground against its triangles, and against time, over tolerances, beside other meshers'
/// figures.
Result<std::vector<Chart>> chart_terrain(const ChartRequest& request);
/// Which outlines are not simple, and time for one, over the grid they are written on, for three ways of computing
/// them.
Result<std::vector<Chart>> chart_junctions(const ChartRequest& request);
/// Processor time of the network and its outlines over the number of ways, and over that of their points, for the 1/16
/// to all of each map's ways that are nearest to its middle; the exponent of the power law through them in the series'
/// names.
Result<std::vector<Chart>> chart_roads(const ChartRequest& request);

/// Certified error, border error, triangles, time and memory of a map's ground over the ladder; its triangles
/// beside 1.3 times those of its heights without borders and two for each vertex of its borders without heights.
Result<std::vector<Chart>> chart_ground(const ChartRequest& request);

/// Triangles of a map's ground for one eye, over the error on its picture: a tolerance a cell, by its distance, beside
/// one tolerance everywhere.
Result<std::vector<Chart>> chart_view(const ChartRequest& request);

/// Earth moved, distance from the heightmap and share over the limit of a map's roads, over the scale of their grade
/// limits.
Result<std::vector<Chart>> chart_profile(const ChartRequest& request);

/// Share of roofs that fail and time for one over the corners of a map's footprints, a form each: by the straight
/// skeleton in doubles, in exact numbers, and as citykiln builds them.
Result<std::vector<Chart>> chart_roof(const ChartRequest& request);

/// Triangles, bytes and time of some of a map's houses over tolerances, and the error of their picture from where the
/// tolerance is one pixel, beside the noise of the picture.
Result<std::vector<Chart>> chart_facade(const ChartRequest& request);

/// Processor time of placing a map's plants over their number.
Result<std::vector<Chart>> chart_woods(const ChartRequest& request);

/// Triangles, bytes and time of plants over tolerances, the error of the picture of a tree and of a wood from where the
/// tolerance is one pixel, beside the noise; a joint's distance to its limit surface over the sides of its stems.
Result<std::vector<Chart>> chart_plant(const ChartRequest& request);

/// Symbols a second over the string's length, symbols over iterations beside what the book's rules give, and meshing
/// time over triangles.
Result<std::vector<Chart>> chart_lsystem(const ChartRequest& request);

/// The scene of the first map that the request names. Errors: none named; as compile().
Result<scene::Scene> compile_first_map(const ChartRequest& request);

/// p of the power law y = c x^p that fits the points, all positive, by least squares of logarithms. 0 for fewer than
/// two different x.
double exponent_of(const Series& series);

}  // namespace citykiln::charts
