// Ways to scatter plants: the least distance between two, and how even their number is on level and steep ground.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "compiler/plants/placing/blue_noise.h"
#include "tests/charts/chart.h"
#include "tests/charts/stopwatch.h"

namespace citykiln::charts {
namespace {

using Places = std::vector<Vec2>;

constexpr double kSide_m = 512, kPerHa = 300, kSpacing_m = 4.6;

/// A plane that falls to the east: its height at a place.
struct Hill {
  double slope = 0;
  double height_m(Vec2 p) const { return slope * p.x; }
  double stretch() const { return std::hypot(1.0, slope); }
};

double ground_distance(const Hill& hill, Vec2 a, Vec2 b) {
  return std::hypot(a.x - b.x, a.y - b.y, hill.height_m(a) - hill.height_m(b));
}

std::size_t wanted(const Hill& hill) {
  return static_cast<std::size_t>(kPerHa * kSide_m * kSide_m * hill.stretch() / 10'000);
}

Places scattered_at_random(const Hill& hill) {
  std::mt19937_64 draw(3);
  std::uniform_real_distribution<double> at(0, kSide_m);
  Places places;
  while (places.size() < wanted(hill)) places.push_back({at(draw), at(draw)});
  return places;
}

/// One plant in each cell of a grid in the plan, moved at random, as RPForest's spawners do.
Places jittered_grid(const Hill& hill) {
  std::mt19937_64 draw(3);
  std::uniform_real_distribution<double> unit(0, 1);
  const int cells = static_cast<int>(std::lround(std::sqrt(static_cast<double>(wanted(hill)))));
  Places places;
  for (int i = 0; i < cells; ++i)
    for (int k = 0; k < cells; ++k)
      places.push_back({(i + unit(draw)) * kSide_m / cells, (k + unit(draw)) * kSide_m / cells});
  return places;
}

/// Poisson disks in the plan by darts, each kept if no other is nearer than the radius.
Places darts_in_plan(const Hill&) {
  std::mt19937_64 draw(3);
  std::uniform_real_distribution<double> at(0, kSide_m);
  const auto cells = static_cast<std::size_t>(kSide_m / kSpacing_m) + 1;
  std::vector<Places> grid(cells * cells);
  Places places;
  for (int dart = 0; dart < 400'000; ++dart) {
    const Vec2 p{at(draw), at(draw)};
    const auto x = static_cast<std::size_t>(p.x / kSpacing_m), y = static_cast<std::size_t>(p.y / kSpacing_m);
    bool is_free = true;
    for (std::size_t j = y > 0 ? y - 1 : 0; j <= std::min(y + 1, cells - 1); ++j)
      for (std::size_t i = x > 0 ? x - 1 : 0; i <= std::min(x + 1, cells - 1); ++i)
        is_free =
            is_free && std::ranges::none_of(grid[j * cells + i], [&](Vec2 q) { return distance(p, q) < kSpacing_m; });
    if (is_free) grid[y * cells + x].push_back(p), places.push_back(p);
  }
  return places;
}

Places blue_noise_on_ground(const Hill& hill) {
  plants::SampleDensity density = plants::density_for(kPerHa);
  density.normal_z = 1 / hill.stretch();
  Places places;
  const Box2 box{{0, 0}, {kSide_m, kSide_m}};
  for (const plants::Sample& sample : plants::blue_noise(
           3, box, [&](const Box2&) { return density.spacing_m; },
           [&](Vec2 p) {
             density.height_m = hill.height_m(p);
             return density;
           }))
    places.push_back(sample.at);
  return places;
}

struct ScatterMethod {
  const char* name;
  Places (*scatter)(const Hill& hill);
};
constexpr ScatterMethod kScatterMethods[] = {{"random", scattered_at_random},
                                             {"jittered grid in the plan", jittered_grid},
                                             {"Poisson disks in the plan (darts)", darts_in_plan},
                                             {"blue noise on the ground (citykiln)", blue_noise_on_ground}};

/// The distance on the ground that so large a share of plants has to its nearest neighbour or less.
double neighbour_m(const Places& places, const Hill& hill, double share) {
  std::vector<double> nearest(places.size(), INFINITY);
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      if (std::abs(places[i].x - places[k].x) > 16) continue;
      const double d = ground_distance(hill, places[i], places[k]);
      nearest[i] = std::min(nearest[i], d), nearest[k] = std::min(nearest[k], d);
    }
  std::ranges::sort(nearest);
  return nearest[static_cast<std::size_t>(share * static_cast<double>(nearest.size() - 1))];
}

/// The variance of the number of plants in squares of 32 m over its mean: 1 for random places, 0 for even ones.
double unevenness(const Places& places) {
  constexpr std::size_t kCells = 16;
  std::vector<double> counts(kCells * kCells);
  for (const Vec2 p : places) {
    const auto cell = [](double c) { return std::min(kCells - 1, static_cast<std::size_t>(c / kSide_m * kCells)); };
    counts[cell(p.y) * kCells + cell(p.x)] += 1;
  }
  double mean = 0, squares = 0;
  for (const double count : counts) mean += count / kCells / kCells;
  for (const double count : counts) squares += (count - mean) * (count - mean) / kCells / kCells;
  return squares / mean;
}

}  // namespace

Result<std::vector<Chart>> chart_scatter(const ChartRequest&) {
  Chart chart{"scatter", "Plants a hectare of ground", {"slope"}, {"plants a hectare of ground"}, {}};
  chart.notes = {
      "| plants | slope | a hectare of ground | least distance (m) | median (m) | variance over mean | µs a plant |",
      "|---|--:|--:|--:|--:|--:|--:|"};
  for (const ScatterMethod& method : kScatterMethods) {
    Series& series = chart.series.emplace_back(Series{method.name, {}});
    for (const double slope : {0.0, 0.5, 1.0}) {
      const Hill hill{slope};
      const Stopwatch watch;
      const Places places = method.scatter(hill);
      const double us = watch.microseconds() / static_cast<double>(places.size());
      const double per_ha = static_cast<double>(places.size()) / (kSide_m * kSide_m * hill.stretch() / 10'000);
      series.points.emplace_back(slope, per_ha);
      chart.notes.push_back(fmt::format("| {} | {} | {:.0f} | {:.2f} | {:.2f} | {:.2f} | {:.1f} |", method.name, slope,
                                        per_ha, neighbour_m(places, hill, 0), neighbour_m(places, hill, 0.5),
                                        unevenness(places), us));
    }
  }
  return std::vector{chart};
}

}  // namespace citykiln::charts
