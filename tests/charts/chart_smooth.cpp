// Errors of surfaces between the samples of heightmaps: each heightmap is thinned, and its other samples are compared.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>

#include "compiler/map/plane/smooth_land.h"
#include "compiler/source/read_raster.h"
#include "compiler/source/voids/fill_gaps.h"
#include "tests/charts/chart.h"
#include "tests/charts/height_grid.h"
#include "tests/charts/stopwatch.h"

namespace citykiln::charts {
namespace {

/// The side of the part that is compared, in samples: a degree of SRTM at 3 seconds.
constexpr int kMostSamplesASide = 1201;

/// A heightmap and the distance of its samples.
struct Samples {
  std::string name;
  HeightGrid grid;
  Vec2 spacing_m;
};

Result<Samples> read_samples(const source::RasterSpec& spec) {
  Result<source::Raster> read = source::read_raster(spec, nullptr);
  if (!read) return read.error();
  Report ignored;
  const source::Raster raster = source::fill_voids(std::move(*read), ignored);
  Samples samples{std::filesystem::path(spec.path).stem().string(),
                  {std::min(raster.columns, kMostSamplesASide), std::min(raster.rows, kMostSamplesASide), {}},
                  raster.spacing_m};
  const int first_column = (raster.columns - samples.grid.columns) / 2;
  const int first_row = (raster.rows - samples.grid.rows) / 2;
  for (int r = 0; r < samples.grid.rows; ++r)
    for (int c = 0; c < samples.grid.columns; ++c)
      samples.grid.heights_m.push_back(raster.at(first_column + c, first_row + r));
  if (samples.grid.columns < 64 || samples.grid.rows < 64) return Error{spec.path, "has fewer than 64 samples a side"};
  return samples;
}

/// Errors at the samples that were left out.
struct SurfaceErrors {
  double height_m = 0, slope = 0;       ///< Root mean squares; the slope's in metres a metre.
  double facet_deg = 0;                 ///< The mean bend at the remaining samples' lines, of places n to a step.
  double overshoot_m = 0, seconds = 0;  ///< The farthest beyond the four samples about a place; of one core.
};

Vec2 slope_at(const HeightGrid& grid, int c, int r, Vec2 spacing_m) {
  return {(grid.at(c + 1, r) - grid.at(c - 1, r)) / (2 * spacing_m.x),
          (grid.at(c, r + 1) - grid.at(c, r - 1)) / (2 * spacing_m.y)};
}

/// The bend of the surface across a column of the grid, in degrees.
double bend_deg(const HeightGrid& grid, int c, int r, Vec2 spacing_m) {
  constexpr double kDegree = 57.29577951308232;
  const double before = (grid.at(c, r) - grid.at(c - 1, r)) / spacing_m.x;
  const double after = (grid.at(c + 1, r) - grid.at(c, r)) / spacing_m.x;
  return std::abs(std::atan(after) - std::atan(before)) * kDegree;
}

/// How far a height lies beyond the four nodes of the coarse grid about it.
double beyond_m(const HeightGrid& coarse, int c, int r, int n, double height_m) {
  const int column = std::min(c / n, coarse.columns - 2), row = std::min(r / n, coarse.rows - 2);
  const auto [low, high] = std::minmax(
      {coarse.at(column, row), coarse.at(column + 1, row), coarse.at(column, row + 1), coarse.at(column + 1, row + 1)});
  return std::max({low - height_m, height_m - high, 0.0});
}

/// Samples nearer to the margin are not compared, as methods differ there.
constexpr int kMargin = 3;

SurfaceErrors errors_of(const SurfaceMethod& method, const Samples& samples, int n) {
  const HeightGrid coarse = thinned(samples.grid, n);
  const Stopwatch watch;
  const HeightGrid fine = method.refined(coarse, n);
  SurfaceErrors errors{.seconds = watch.seconds()};
  double left_out = 0, bends = 0;
  for (int r = kMargin * n; r < fine.rows - kMargin * n; ++r)
    for (int c = kMargin * n; c < fine.columns - kMargin * n; ++c) {
      if (c % n == 0) errors.facet_deg += bend_deg(fine, c, r, samples.spacing_m), ++bends;
      errors.overshoot_m = std::max(errors.overshoot_m, beyond_m(coarse, c, r, n, fine.at(c, r)));
      if (c % n == 0 && r % n == 0) continue;
      const double off_m = fine.at(c, r) - samples.grid.at(c, r);
      const Vec2 slope_off = slope_at(fine, c, r, samples.spacing_m) - slope_at(samples.grid, c, r, samples.spacing_m);
      errors.height_m += off_m * off_m, errors.slope += dot(slope_off, slope_off), ++left_out;
    }
  errors.height_m = std::sqrt(errors.height_m / left_out), errors.slope = std::sqrt(errors.slope / left_out);
  errors.facet_deg /= bends;
  return errors;
}

/// Bends between neighbouring faces along rows of a grid of heights, in degrees.
struct Facets {
  double mean_deg = 0, hundredth_deg = 0;  ///< A hundredth of the bends are larger.
};

Facets facets_of(const HeightGrid& grid, Vec2 spacing_m) {
  std::vector<double> bends_deg;
  for (int r = 0; r < grid.rows; ++r)
    for (int c = 1; c + 1 < grid.columns; ++c) bends_deg.push_back(bend_deg(grid, c, r, spacing_m));
  const auto hundredth = bends_deg.begin() + static_cast<std::ptrdiff_t>(bends_deg.size() * 99 / 100);
  std::ranges::nth_element(bends_deg, hundredth);
  return {std::accumulate(bends_deg.begin(), bends_deg.end(), 0.0) / static_cast<double>(bends_deg.size()), *hundredth};
}

/// The distance of the triangles between a grid's places from the surface on which these lie.
SurfaceErrors distance_from_surface(const HeightGrid& places, const HeightGrid& surface, int n) {
  SurfaceErrors off;
  const HeightGrid triangles = surface_methods().front().refined(places, n);
  for (std::size_t i = 0; i < triangles.heights_m.size(); ++i) {
    const double off_m = std::abs(triangles.heights_m[i] - surface.heights_m[i]);
    off.height_m += off_m * off_m, off.overshoot_m = std::max(off.overshoot_m, off_m);
  }
  off.height_m = std::sqrt(off.height_m / static_cast<double>(triangles.heights_m.size()));
  return off;
}

/// The effect of dividing the steps: facets before and after, and the distance of the field from the surface.
std::string note_of_division(const Samples& samples) {
  const int parts = map::smooth_parts(samples.spacing_m);
  const SurfaceMethod limited = surface_methods()[kOfCompile];
  const HeightGrid field = limited.refined(samples.grid, parts);
  const Facets before = facets_of(samples.grid, samples.spacing_m),
               after = facets_of(field, samples.spacing_m * (1.0 / parts));
  const SurfaceErrors off = distance_from_surface(field, limited.refined(samples.grid, 8), 8 / parts);
  return fmt::format(
      "{}, {} parts: bends {:.2f} -> {:.2f} deg, a hundredth above {:.1f} -> {:.1f} deg; off the surface by {:.3f} m "
      "(r.m.s.), at most {:.2f} m",
      samples.name, parts, before.mean_deg, after.mean_deg, before.hundredth_deg, after.hundredth_deg, off.height_m,
      off.overshoot_m);
}

/// Two charts of one heightmap, with all measures as notes.
std::vector<Chart> charts_of(const Samples& samples) {
  const std::string title = fmt::format("{} thinned; samples every {:.1f} by {:.1f} m", samples.name,
                                        samples.spacing_m.x, samples.spacing_m.y);
  Chart heights{"smooth_heights_" + samples.name,
                "Error of heights between samples: " + title,
                {"every n-th sample", true},
                {"r.m.s. of heights left out (m)", true},
                {}};
  Chart slopes{"smooth_slopes_" + samples.name,
               "Error of slopes between samples: " + title,
               {"every n-th sample", true},
               {"r.m.s. of slopes left out (%)", true},
               {}};
  heights.notes = {
      "| surface | n | heights, r.m.s. (m) | slopes, r.m.s. (%) | bend at samples (°) | overshoot (m) | s |",
      "|---|---|---|---|---|---|---|"};
  for (const SurfaceMethod& method : surface_methods()) {
    heights.series.push_back({method.name, {}}), slopes.series.push_back({method.name, {}});
    for (const int n : {2, 4, 8}) {
      const SurfaceErrors errors = errors_of(method, samples, n);
      heights.series.back().points.emplace_back(n, errors.height_m);
      slopes.series.back().points.emplace_back(n, errors.slope * 100);
      heights.notes.push_back(fmt::format("| {} | {} | {:.3f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} |", method.name, n,
                                          errors.height_m, errors.slope * 100, errors.facet_deg, errors.overshoot_m,
                                          errors.seconds));
    }
  }
  heights.notes.push_back(note_of_division(samples));
  return {heights, slopes};
}

}  // namespace

Result<std::vector<Chart>> chart_smooth(const ChartRequest& request) {
  if (request.rasters.empty()) return Error{"chart smooth", "needs a heightmap (--dem FILE)"};
  std::vector<Chart> charts;
  for (const source::RasterSpec& spec : request.rasters) {
    const Result<Samples> samples = read_samples(spec);
    if (!samples) return samples.error();
    for (Chart& chart : charts_of(*samples)) charts.push_back(std::move(chart));
  }
  return charts;
}

}  // namespace citykiln::charts
