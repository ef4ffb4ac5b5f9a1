// Growth of processor time of the road network and its outlines with the size of the map, for nested parts of each map.
#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <ctime>
#include <filesystem>

#include "compiler/geometry/box.h"
#include "compiler/roads/junctions/junction.h"
#include "tests/charts/chart.h"
#include "tests/charts/read_roads.h"

namespace citykiln::charts {
namespace {

using roads::Road;

constexpr int kNetworkRuns = 5;

/// The `count` roads nearest to the map's middle, sorted by id.
std::vector<Road> nearest(const std::vector<Road>& all, std::size_t count) {
  Box2 box;
  for (const Road& road : all) box.grow(box_of(road.axis).centre());
  const Vec2 middle = box.centre();
  std::vector<Road> part = all;
  std::ranges::sort(part, {},
                    [&](const Road& road) { return std::pair(distance(box_of(road.axis).centre(), middle), road.id); });
  part.resize(count);
  std::ranges::sort(part, {}, &Road::id);
  return part;
}

/// Processor time of all threads, which other processes on the machine do not change.
double seconds_once(const std::vector<Road>& part, int threads) {
  Report ignored;
  const std::clock_t begin = std::clock();
  const std::vector<roads::Junction> junctions = roads::plan_junctions(part, ignored);
  const auto outlines = roads::outline_junctions(junctions, part, threads);
  // a small part may take less than a tick
  return static_cast<double>(std::max<std::clock_t>(std::clock() - begin, 1)) / CLOCKS_PER_SEC;
}

double median_seconds(const std::vector<Road>& part, int threads) {
  std::vector<double> times(kNetworkRuns);
  for (double& time : times) time = seconds_once(part, threads);
  std::ranges::sort(times);
  return times[kNetworkRuns / 2];
}

double points_of(const std::vector<Road>& part) {
  double points = 0;
  for (const Road& road : part) points += static_cast<double>(road.axis.size());
  return points;
}

/// Time over the number of ways and over the number of axis points: rural ways have more points than urban ones.
struct Growth {
  Series by_ways, by_points;
};

Growth growth_of(const std::vector<Road>& all, int threads) {
  Growth growth;
  for (const std::size_t share : {16, 8, 4, 2, 1}) {
    if (all.size() < share) continue;
    const std::vector<Road> part = nearest(all, all.size() / share);
    const double seconds = median_seconds(part, threads);
    growth.by_ways.points.emplace_back(static_cast<double>(part.size()), seconds);
    growth.by_points.points.emplace_back(points_of(part), seconds);
  }
  return growth;
}

Chart chart_over(const std::string& what) {
  Chart chart;
  chart.name = "roads_by_" + what;
  chart.title = "n " + what;
  chart.x = {what, true};
  chart.y = {"network and outlines, median of 5 (processor seconds)", true};
  return chart;
}

/// Adds a series named after the map and the exponent of its power law.
void add_series(Series series, const std::string& path, Chart& chart) {
  const double power = exponent_of(series);
  series.name = fmt::format("{}: n^{:.2f}", std::filesystem::path(path).stem().stem().string(), power);
  chart.title += fmt::format("{} {:.2f}", chart.series.empty() ? ": time as n to the" : ",", power);
  chart.series.push_back(std::move(series));
}

}  // namespace

double exponent_of(const Series& series) {
  assert(std::ranges::all_of(series.points, [](const auto& p) { return p.first > 0 && p.second > 0; }));
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const auto& [at, value] : series.points) {
    const double u = std::log(at), v = std::log(value);
    n += 1, x += u, y += v, xx += u * u, xy += u * v;
  }
  const double spread = n * xx - x * x;
  return spread > 0 ? (n * xy - x * y) / spread : 0;
}

Result<std::vector<Chart>> chart_roads(const ChartRequest& request) {
  if (request.maps.empty()) return Error{"chart roads", "needs maps (--map FILE)"};
  Chart by_ways = chart_over("ways"), by_points = chart_over("points");
  for (const std::string& path : request.maps) {
    const Result<std::vector<Road>> all = read_roads(path, request.threads);
    if (!all) return all.error();
    if (all->empty()) return Error{path, "has no roads"};
    Growth growth = growth_of(*all, request.threads);
    add_series(std::move(growth.by_ways), path, by_ways);
    add_series(std::move(growth.by_points), path, by_points);
  }
  return std::vector{by_ways, by_points};
}

}  // namespace citykiln::charts
