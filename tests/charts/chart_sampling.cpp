// The error of a pixel's mean over its number of samples: independent random points, jittered strata, and the
// previewer's points.
#include <fmt/format.h>

#include <cmath>
#include <random>

#include "preview/samples.h"
#include "tests/charts/chart.h"

namespace citykiln::charts {
namespace {

using preview::UnitPair;
using SamplePoints = std::vector<UnitPair>;

/// A function of the pixel with its exact mean: the light that comes through it.
struct PixelLight {
  const char* name;
  double (*light)(UnitPair p);
  double mean;
};

constexpr PixelLight kLights[] = {
    {"a soft shadow", [](UnitPair p) { return p.u * p.v; }, 0.25},
    {"the edge of a wall", [](UnitPair p) { return p.v < 0.3 + 0.4 * p.u ? 1.0 : 0.0; }, 0.5},
    {"a round lamp", [](UnitPair p) { return std::hypot(p.u - 0.5, p.v - 0.5) < 0.25 ? 1.0 : 0.0; },
     0.19634954084936207}};

SamplePoints random_points(std::mt19937_64& draw, int side) {
  std::uniform_real_distribution<double> unit(0, 1);
  SamplePoints points;
  for (int i = 0; i < side * side; ++i) points.push_back({unit(draw), unit(draw)});
  return points;
}

SamplePoints jittered_points(std::mt19937_64& draw, int side) {
  std::uniform_real_distribution<double> unit(0, 1);
  SamplePoints points;
  for (int i = 0; i < side; ++i)
    for (int k = 0; k < side; ++k) points.push_back({(i + unit(draw)) / side, (k + unit(draw)) / side});
  return points;
}

SamplePoints sobol_points(std::mt19937_64& draw, int side) {
  const preview::PixelSamples pixel(draw(), 0, 0, preview::grid_of(1, 1, side * side));
  SamplePoints points;
  for (int i = 0; i < side * side; ++i) points.push_back(pixel.pair(static_cast<std::uint32_t>(i), 0));
  return points;
}

struct PointMethod {
  const char* name;
  SamplePoints (*points)(std::mt19937_64& draw, int side);
};
constexpr PointMethod kPointMethods[] = {
    {"random", random_points}, {"jittered strata", jittered_points}, {"Owen-scrambled Sobol (citykiln)", sobol_points}};

/// The root mean square error of the pixel's mean over many pixels, relative to the mean.
double error_of_pixel(const PointMethod& method, const PixelLight& light, int side) {
  constexpr int kPixels = 4000;
  std::mt19937_64 draw(1);
  double squares = 0;
  for (int pixel = 0; pixel < kPixels; ++pixel) {
    const SamplePoints points = method.points(draw, side);
    double sum = 0;
    for (const UnitPair p : points) sum += light.light(p);
    squares += std::pow(sum / static_cast<double>(points.size()) - light.mean, 2);
  }
  return std::sqrt(squares / kPixels) / light.mean;
}

}  // namespace

Result<std::vector<Chart>> chart_sampling(const ChartRequest&) {
  constexpr int kSides[] = {1, 2, 4, 8, 16};
  std::vector<Chart> charts;
  for (const PixelLight& light : kLights) {
    Chart chart{fmt::format("sampling_{}", charts.size()),
                fmt::format("Error of a pixel: {}", light.name),
                {"samples", true},
                {"RMS error over the mean", true},
                {}};
    if (charts.empty())
      chart.notes = {"| pixel | points | 1 | 4 | 16 | 64 | 256 samples |", "|---|---|--:|--:|--:|--:|--:|"};
    for (const PointMethod& method : kPointMethods) {
      Series& series = chart.series.emplace_back(Series{method.name, {}});
      std::string row = fmt::format("| {} | {} |", light.name, method.name);
      for (const int side : kSides) {
        series.points.emplace_back(side * side, error_of_pixel(method, light, side));
        row += fmt::format(" {:.2g} |", series.points.back().second);
      }
      chart.notes.push_back(row);
    }
    charts.push_back(std::move(chart));
  }
  return charts;
}

}  // namespace citykiln::charts
