// How near invented towns are to mapped ones: the distributions of six measures, and the distances between them.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "compiler/invent/town/add_town.h"
#include "tests/charts/chart.h"
#include "tests/charts/town_shape.h"

namespace citykiln::charts {
namespace {

struct MeasureRow {
  const char* name;
  const char* label;
  bool is_logarithmic;
};
constexpr std::array<MeasureRow, 6> kMeasures = {{{"street_density", "streets (km/km²)", false},
                                                  {"junction_degree", "arms of a junction", false},
                                                  {"block_area", "area of a block (m²)", true},
                                                  {"lot_front", "front of a lot (m)", true},
                                                  {"footprint_area", "area of a footprint (m²)", true},
                                                  {"height", "height (m)", true}}};

struct MeasuredTown {
  std::string name;
  bool is_invented = false;
  std::vector<TownValues> values;
};

/// The towns that are invented: a side and seeds for each kind.
struct InventedRow {
  const char* name;
  invent::TownKind kind;
  double side_m;
};
constexpr std::array kInvented = {InventedRow{"village", invent::TownKind::kVillage, 1200},
                                  InventedRow{"town", invent::TownKind::kTown, 2400},
                                  InventedRow{"city", invent::TownKind::kCity, 3000}};
constexpr std::uint64_t kSeeds = 3;

// gentle slopes without water: what is compared is the town, not its place
invent::Terrain gentle_terrain(double side_m) {
  invent::Terrain terrain;
  terrain.side_m = side_m;
  terrain.cells = 2;
  terrain.sea_level_m = -1000;
  terrain.heights_m = {10, 14, 12, 8, 20, 15, 9, 12, 16};
  return terrain;
}

MeasuredTown measured_invented(const InventedRow& row, std::uint64_t seed, int threads) {
  const invent::Terrain terrain = gentle_terrain(row.side_m);
  invent::InventedMap map;
  invent::add_town(terrain, {row.kind, row.side_m, seed}, map);
  const std::string name = fmt::format("{} {}", row.name, seed);
  return {name, true, measure_town(town_map_of(map, row.side_m, name), threads)};
}

// the distribution as a curve of at most 200 points
Series curve_of(const MeasuredTown& town, std::size_t measure) {
  const TownValues& values = town.values[measure];
  Series series{town.name, {}, false};
  constexpr std::size_t kPoints = 200;
  for (std::size_t k = 0; k <= kPoints && !values.empty(); ++k) {
    const std::size_t i = std::min(values.size() - 1, k * values.size() / kPoints);
    series.points.push_back({values[i], static_cast<double>(k) / kPoints});
  }
  return series;
}

double median_of(const TownValues& values) { return values.empty() ? 0 : values[values.size() / 2]; }

// the largest distance of a town from the mapped ones, itself left out
double farthest(const MeasuredTown& town, const std::vector<MeasuredTown>& towns, std::size_t measure) {
  double most = 0;
  for (const MeasuredTown& other : towns)
    if (!other.is_invented && &other != &town && !other.values[measure].empty())
      most = std::max(most, kolmogorov_distance(town.values[measure], other.values[measure]));
  return most;
}

// a row of the table: median of the measure, and the distance
std::string row_of_town(const MeasuredTown& town, const std::vector<MeasuredTown>& towns) {
  std::string row = "| " + town.name;
  for (std::size_t m = 0; m < kMeasures.size(); ++m)
    row += town.values[m].empty()
               ? " | "
               : fmt::format(" | {:.3g}, {:.2f}", median_of(town.values[m]), farthest(town, towns, m));
  return row + " |";
}

Chart measure_chart(std::size_t measure, const std::vector<MeasuredTown>& towns) {
  const MeasureRow& row = kMeasures[measure];
  Chart chart{
      fmt::format("invented_{}", row.name), "", {row.label, row.is_logarithmic}, {"share of values below", false}, {}};
  double between_mapped = 0, of_invented = 0;
  for (const MeasuredTown& town : towns) {
    chart.series.push_back(curve_of(town, measure));
    if (town.values[measure].empty()) continue;
    double& most = town.is_invented ? of_invented : between_mapped;
    most = std::max(most, farthest(town, towns, measure));
  }
  chart.title = fmt::format("{}: mapped towns are up to {:.2f} apart, invented ones up to {:.2f} from them", row.label,
                            between_mapped, of_invented);
  return chart;
}

}  // namespace

Result<std::vector<Chart>> chart_invented(const ChartRequest& request) {
  if (request.maps.size() < 2) return Error{"chart invented", "needs two maps of towns or more (--map FILE)"};
  std::vector<MeasuredTown> towns;
  for (const std::string& path : request.maps) {
    const Result<TownMap> map = read_town_map(path, request.threads);
    if (!map) return map.error();
    towns.push_back({map->name, false, measure_town(*map, request.threads)});
  }
  for (const InventedRow& row : kInvented)
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) towns.push_back(measured_invented(row, seed, request.threads));
  std::vector<Chart> charts;
  for (std::size_t m = 0; m < kMeasures.size(); ++m) charts.push_back(measure_chart(m, towns));
  std::string head = "| town", line = "|---";
  for (const MeasureRow& row : kMeasures) {
    head += fmt::format(" | {}", row.label);
    line += "|---";
  }
  charts.back().notes = {head + " |", line + "|"};
  for (const MeasuredTown& town : towns) charts.back().notes.push_back(row_of_town(town, towns));
  return charts;
}

}  // namespace citykiln::charts
