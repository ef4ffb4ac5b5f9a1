// Charts of speed and accuracy. Each is a set of series of points, written as CSV and drawn as SVG by gnuplot.
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

/// One axis of a chart.
struct Axis {
  std::string label;  ///< With a unit: "distance from the origin (km)".
  bool is_logarithmic = false;
};

/// A curve of a chart.
struct Series {
  std::string name;
  std::vector<std::pair<double, double>> points;
  bool is_reference = false;  ///< Published results of another program, drawn as points without a line.
};

/// A chart: labels and curves.
struct Chart {
  std::string name;  ///< The name of its files, such as "plane_length".
  std::string title;
  Axis x, y;
  std::vector<Series> series;
  std::vector<std::string> notes{};  ///< Lines that the program prints, such as the rows of a table.
};

/// Writes NAME.csv (columns series, x, y) and NAME.svg into the folder. Errors: a folder that cannot be written;
/// gnuplot missing or failing, in which case the CSV remains.
Result<Done> write_chart(const Chart& chart, const std::string& folder);

/// The options of citykiln-chart.
struct ChartRequest {
  std::vector<std::string> names;
  std::string folder;
  source::LonLatBox bbox;  ///< The area of the terrain chart, if has_bbox; else all of the heightmap.
  bool has_bbox = false;
  std::vector<source::RasterSpec> rasters;  ///< Heightmaps. The terrain chart uses only the first.
  /// The maps of all charts except plane, terrain, smooth, canopy, plant, lsystem, lights, sky, linelights,
  /// cloud, air, sampling, hierarchy, scatter and stability.
  std::vector<std::string> maps;
  std::optional<Vec3> eye;  ///< The viewer of the view chart; empty: 100 m above the middle of the map.
  double lat_deg = 42.5;    ///< The latitude of the plane chart's origin.
  double cell_m = 1024;     ///< The side of the terrain chart's cells.
  int threads = 0;
};

/// Charts the errors of lengths and angles of the plane against geodesics over the distance from the origin, with other
/// projections for comparison. Series names contain the time per point.
Result<std::vector<Chart>> chart_plane(const ChartRequest& request);
/// Charts the vertical error of terrain meshes over triangles and over time, at several tolerances, with the results of
/// other meshers.
Result<std::vector<Chart>> chart_terrain(const ChartRequest& request);
/// Charts the errors of heights and slopes between the samples of heightmaps: every 2nd, 4th and 8th sample is kept,
/// and surfaces through them are compared at the others. Two charts for each heightmap; notes are a Markdown table with
/// the bends at samples, the overshoot and the time too. Errors: no heightmap, or fewer than 64 samples a side.
Result<std::vector<Chart>> chart_smooth(const ChartRequest& request);
/// Charts the share of invalid junction outlines and the time for one, over the grid step of the coordinates, for three
/// methods.
Result<std::vector<Chart>> chart_junctions(const ChartRequest& request);
/// Charts the share of inner nodes of streets at which the axis turns by more than an angle, as mapped and with curves.
/// Notes are a Markdown table that has the distances of curves from the mapped lines too.
Result<std::vector<Chart>> chart_curves(const ChartRequest& request);
/// Charts the processor time of the road network and its outlines over the numbers of ways and of their points, for the
/// 1/16 to all of a map's ways nearest to its middle. Series names contain the exponent of the fitted power law.
Result<std::vector<Chart>> chart_roads(const ChartRequest& request);

/// Charts the certified error, border error, triangles, time and memory of a map's ground over the tolerances. The
/// bound on triangles is 1.3 times those of the heights without borders, plus two for each vertex of the borders
/// without heights.
Result<std::vector<Chart>> chart_ground(const ChartRequest& request);

/// Charts the triangles of a map's ground over the error in one viewer's picture: with tolerances by distance, with one
/// tolerance, and of a right-triangulated irregular network of the heights.
Result<std::vector<Chart>> chart_view(const ChartRequest& request);

/// Charts the earth moved for a map's roads, their distance from the heightmap and the share over the grade limit, over
/// a factor on the limits.
Result<std::vector<Chart>> chart_profile(const ChartRequest& request);

/// Charts the share of failed roofs and the time for one, over the corners of a map's footprints, for several forms:
/// straight skeletons in floating point, in exact arithmetic, and in citykiln's combination of both.
Result<std::vector<Chart>> chart_roof(const ChartRequest& request);

/// Charts the triangles, bytes and time of some of a map's houses over the tolerance, and the error of their picture at
/// the distance where the tolerance is one pixel, with the noise of the picture.
Result<std::vector<Chart>> chart_facade(const ChartRequest& request);

/// Charts the processor time of placing a map's plants over their number.
Result<std::vector<Chart>> chart_woods(const ChartRequest& request);

/// Charts the look and the cost of a closed wood of 256 m over the tolerance, as trees, as stands and as a canopy: the
/// difference of its picture from that of a fine level, at the distance where the tolerance is one pixel, its bytes,
/// triangles and processor time, each without the ground. Writes the wood's map, wood.osm, into the folder of the
/// charts. Notes are a Markdown table.
Result<std::vector<Chart>> chart_canopy(const ChartRequest& request);

/// Charts three measures of plants: triangles, bytes and time over the tolerance; the error of the picture of a tree
/// and of a wood at the distance where the tolerance is one pixel, with the noise; the distance of a branch joint's
/// mesh from its limit surface over the number of sides of its stems.
Result<std::vector<Chart>> chart_plant(const ChartRequest& request);

/// Charts the symbols per second over the length of the string, the symbols over iterations with the number that the
/// rules give, and the meshing time over triangles.
Result<std::vector<Chart>> chart_lsystem(const ChartRequest& request);

/// Charts the bits per triangle over the longest move of a vertex, and the speed of writing and reading over the step
/// of positions, for each way of packing. Measured on the meshes of the tile with most buildings at 0.1 m, without
/// instances and images. The map may be a manifest (.kiln).
Result<std::vector<Chart>> chart_compression(const ChartRequest& request);

/// Charts, for each kind of object in the 128 m tile of a map with the most buildings, four measures over triangles:
/// distance from the finest level (sampled both ways), error of the picture, bytes and time. It compares levels made
/// from recipes with the finest level simplified to as many triangles by OpenMesh and by meshoptimizer.
Result<std::vector<Chart>> chart_lod(const ChartRequest& request);

/// Charts the relative error of a map's street over rendering time, against a long reference, for numbers of samples
/// and bounces, Russian roulette and denoising.
Result<std::vector<Chart>> chart_render(const ChartRequest& request);

/// Charts the time and memory of a map's street rendered from stored tiles and from recipes: over the number of tiles,
/// over the budget for generated cells, and with buildings one to three times as high. Memory is that of meshes,
/// hierarchies, textures, and stored tiles.
Result<std::vector<Chart>> chart_forms(const ChartRequest& request);

/// Charts the relative error of the light of many lamps when only one of them is sampled, over their number. The lamp
/// is chosen by the light tree, or uniformly. Needs no map.
Result<std::vector<Chart>> chart_lights(const ChartRequest& request);

/// Charts the luminance of the sky along the sun's vertical for four heights of the sun, by the sky model, by
/// Preetham's, and by a spectral Monte Carlo integration; errors of the model over the whole sky, and the time to
/// prepare it, over the sun's height. Needs no map.
Result<std::vector<Chart>> chart_sky(const ChartRequest& request);
/// Charts the irradiance by the line lights inside of a cylinder: the error of samples on the lines over their time,
/// and the closed form; and that of samples beside a wall. Needs no map.
Result<std::vector<Chart>> chart_linelights(const ChartRequest& request);
/// Charts the error of a pixel's mean over its number of samples, for random, jittered and the previewer's points.
/// Notes are a Markdown table. Needs no map.
Result<std::vector<Chart>> chart_sampling(const ChartRequest& request);
/// Charts the time of a ray over the triangles of a mesh, each tested and by Embree's hierarchy. Notes are a Markdown
/// table. Needs no map.
Result<std::vector<Chart>> chart_hierarchy(const ChartRequest& request);
/// Charts the number of plants a hectare of ground over the slope, for four ways to scatter them. Notes are a Markdown
/// table with the least distances. Needs no map.
Result<std::vector<Chart>> chart_scatter(const ChartRequest& request);
/// Charts the share of failures of textbook methods and of citykiln's on input that breaks the former. Notes are a
/// Markdown table. Needs no map.
Result<std::vector<Chart>> chart_stability(const ChartRequest& request);
/// Charts the density of air over the distance from the axis of a cylinder of 8 km, for three constants. Notes have the
/// largest error of columns of air. Needs no map.
Result<std::vector<Chart>> chart_air(const ChartRequest& request);
/// Charts the errors of optical depth over particles for three cumulus clouds; their light, and that of single
/// scattering, relative to the light by path tracing; and the time of paths relative to that of CloudField.
Result<std::vector<Chart>> chart_cloud(const ChartRequest& request);

/// Charts how well assumptions hold. Tags of pavements, light, lamps, widths, heights and storeys are left out and
/// assumed again: of a whole place, beside a constant by class of the other maps; and in blocks of 256 m like the
/// fields of a checkerboard, one colour after the other, beside the mean of the nearest tagged neighbours. Each chart
/// has the score of the assumption over that of the simple guess, one point a map: the balanced accuracy or the median
/// error. Notes are a Markdown table with a row for each map; of errors it has the median and the 90th percentile.
Result<std::vector<Chart>> chart_assumed(const ChartRequest& request);

/// Charts the distributions of six measures of towns: street density, arms of junctions, areas of blocks, fronts of
/// lots, areas of footprints, heights; of the maps of the request and of nine invented towns (town_shape.h). Titles
/// have the largest Kolmogorov distances. Notes are a Markdown table with the median of each measure and the largest
/// distance from a mapped town. Errors: fewer than two maps, or one that cannot be read.
Result<std::vector<Chart>> chart_invented(const ChartRequest& request);

/// Compiles the first map of the request. Errors: no map, or an error of compile().
Result<scene::Scene> compile_first_map(const ChartRequest& request);

/// Returns the exponent p of the power law y = c x^p fitted to the points (all positive) by least squares of
/// logarithms. 0 for fewer than two different x.
double exponent_of(const Series& series);

}  // namespace citykiln::charts
