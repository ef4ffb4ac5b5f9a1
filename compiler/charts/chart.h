// Charts of speed and accuracy: series of points, written as CSV and drawn as SVG by gnuplot.
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
  std::string label;  ///< With a unit: "distance from the origin (km)".
  bool is_logarithmic = false;
};

struct Series {
  std::string name;
  std::vector<std::pair<double, double>> points;
  bool is_reference = false;  ///< Published results of another program: drawn as points without a line.
};

struct Chart {
  std::string name;  ///< Of the files, such as "plane_length".
  std::string title;
  Axis x, y;
  std::vector<Series> series;
};

/// Writes NAME.csv (columns series, x, y) and NAME.svg into the folder. Errors: a folder that cannot be written;
/// gnuplot missing or failing, in which case the CSV remains.
Result<Done> write_chart(const Chart& chart, const std::string& folder);

/// The options of `citykiln chart`.
struct ChartRequest {
  std::vector<std::string> names;
  std::string folder;
  source::LonLatBox bbox;  ///< Of the terrain chart, if has_bbox; else all of the heightmap.
  bool has_bbox = false;
  std::vector<source::RasterSpec> rasters;  ///< The terrain chart uses the first.
  std::vector<std::string> maps;            ///< Of all charts except plane, terrain, plant and lsystem.
  std::optional<Vec3> eye;                  ///< Viewer of the view chart; else 100 m above the middle of the map.
  double lat_deg = 42.5;                    ///< Origin of the plane chart.
  double cell_m = 1024;                     ///< Of the terrain chart.
  int threads = 0;
};

/// Errors of lengths and angles of the plane against geodesics over the distance from the origin, with other
/// projections for comparison. Series names contain the time per point.
Result<std::vector<Chart>> chart_plane(const ChartRequest& request);
/// Vertical error of terrain meshes over triangles and over time, at several tolerances, with other meshers' results.
Result<std::vector<Chart>> chart_terrain(const ChartRequest& request);
/// Share of invalid junction outlines and time for one, over the coordinates' grid step, for three methods.
Result<std::vector<Chart>> chart_junctions(const ChartRequest& request);
/// Processor time of the road network and its outlines over the number of ways and of their points, for the 1/16 to all
/// of a map's ways nearest to its middle. Series names contain the exponent of the fitted power law.
Result<std::vector<Chart>> chart_roads(const ChartRequest& request);

/// Certified error, border error, triangles, time and memory of a map's ground over the tolerances. The bound on
/// triangles is 1.3 times those of the heights without borders, plus two for each vertex of the borders without
/// heights.
Result<std::vector<Chart>> chart_ground(const ChartRequest& request);

/// Triangles of a map's ground over the error on one viewer's picture: with tolerances by distance, and with one
/// tolerance.
Result<std::vector<Chart>> chart_view(const ChartRequest& request);

/// Earth moved, distance from the heightmap and share over the grade limit of a map's roads, over a factor on the
/// limits.
Result<std::vector<Chart>> chart_profile(const ChartRequest& request);

/// Share of failed roofs and time for one, over the corners of a map's footprints, for several forms: straight
/// skeletons in floating point, in exact arithmetic, and as citykiln combines them.
Result<std::vector<Chart>> chart_roof(const ChartRequest& request);

/// Triangles, bytes and time of some of a map's houses over the tolerance, and the error of their picture at the
/// distance where the tolerance is one pixel, with the noise of the picture.
Result<std::vector<Chart>> chart_facade(const ChartRequest& request);

/// Processor time of placing a map's plants over their number.
Result<std::vector<Chart>> chart_woods(const ChartRequest& request);

/// Triangles, bytes and time of plants over the tolerance; the error of the picture of a tree and of a wood at the
/// distance where the tolerance is one pixel, with the noise; the distance of a joint's mesh from its limit surface
/// over the number of sides of its stems.
Result<std::vector<Chart>> chart_plant(const ChartRequest& request);

/// Symbols a second over the length of the string, symbols over iterations against the number that the rules give, and
/// meshing time over triangles.
Result<std::vector<Chart>> chart_lsystem(const ChartRequest& request);

/// Bits per triangle over the longest move of a vertex, and speed of writing and reading over the step of positions,
/// for each way of packing: the meshes of the tile with most buildings at 0.1 m, without instances and images. The map
/// may be a manifest (.kiln).
Result<std::vector<Chart>> chart_compression(const ChartRequest& request);

/// For each kind of object of the 128 m tile of a map with the most buildings, over triangles: distance from the finest
/// level (sampled both ways), error of the picture, bytes and time, of levels cut from recipes and of the finest level
/// simplified to as many triangles by OpenMesh and by meshoptimizer.
Result<std::vector<Chart>> chart_lod(const ChartRequest& request);

/// Relative error of a map's street over rendering time, against a long reference, for numbers of samples and bounces,
/// Russian roulette and denoising.
Result<std::vector<Chart>> chart_render(const ChartRequest& request);

/// Time and memory of a map's street rendered from stored tiles and from recipes: over the number of tiles, over the
/// budget for generated cells, and with buildings one to three times as high. Memory is that of meshes, hierarchies,
/// textures, and of stored tiles.
Result<std::vector<Chart>> chart_forms(const ChartRequest& request);

/// Relative error of the light of many lamps by one of them, over their number: chosen by the light tree, or uniformly.
/// Needs no map.
Result<std::vector<Chart>> chart_lights(const ChartRequest& request);

/// Luminance of the sky along the sun's vertical for four heights of the sun, by the sky model, by Preetham's, and by a
/// spectral Monte Carlo integration; errors of the model over the whole sky, and the time to prepare it, over the sun's
/// height. Needs no map.
Result<std::vector<Chart>> chart_sky(const ChartRequest& request);
/// Errors of optical depth over particles for three cumulus clouds; their light, and that of single scattering, over
/// that of paths; the time of paths over that of CloudField.
Result<std::vector<Chart>> chart_cloud(const ChartRequest& request);

/// Compiles the first map of the request. Errors: no map; those of compile().
Result<scene::Scene> compile_first_map(const ChartRequest& request);

/// The exponent p of the power law y = c x^p fitted to the points (all positive) by least squares of logarithms. 0 for
/// fewer than two different x.
double exponent_of(const Series& series);

}  // namespace citykiln::charts
