// Speed of L-system derivation and meshing, for Honda's tree (figure 2.6 a of "The Algorithmic Beauty of Plants").
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lsystems/mesh/tubes.h"
#include "lsystems/reading/read_lsystem.h"
#include "lsystems/rewriting/turtle.h"
#include "tests/charts/chart.h"
#include "tests/charts/stopwatch.h"

namespace citykiln::charts {
namespace {

constexpr const char* kHonda =
    "n: 10\nwidth unit: 0.02\naxiom: A(1,10)\n"
    "A(l,w) -> !(w)F(l)[&(45)B(l*0.6,w*0.707)]/(137.5)A(l*0.9,w*0.707)\n"
    "B(l,w) -> !(w)F(l)[-(45)$C(l*0.6,w*0.707)]C(l*0.9,w*0.707)\n"
    "C(l,w) -> !(w)F(l)[+(45)$B(l*0.6,w*0.707)]B(l*0.9,w*0.707)\n";
// Below ten thousand triangles the fixed cost of a call dominates.
constexpr int kMostSteps = 17, kFewestMeshed = 9, kMostMeshed = 16, kRuns = 3;
/// Symbols a second of RPForest on one core of a desktop computer.
constexpr double kOthersFewest = 12e6, kOthersMost = 17e6;

template <typename Work>
double fastest_s(Work work) {
  double fastest = 1e300;
  for (int run = 0; run < kRuns; ++run) {
    const Stopwatch watch;
    work();
    fastest = std::min(fastest, watch.seconds());
  }
  return fastest;
}

/// The number of symbols by the book's rules: each apex becomes two apices and six other modules.
double expected_symbols(int steps) {
  double apices = 1, others = 0;
  for (int i = 0; i < steps; ++i) others += 6 * apices, apices *= 2;
  return apices + others;
}

std::vector<Chart> empty_derivation_charts() {
  std::vector<Chart> charts(3);
  charts[0].name = "lsystem_speed", charts[0].title = "Rewriting Honda's tree, one core";
  charts[0].x = {"symbols of the string", true}, charts[0].y = {"symbols a second", true};
  charts[0].series = {{"citykiln", {}}, {"RPForest, from", {}, true}, {"RPForest, to", {}, true}};
  charts[1].name = "lsystem_growth", charts[1].title = "Symbols of Honda's tree";
  charts[1].x = {"iterations"}, charts[1].y = {"symbols", true};
  charts[1].series = {{"citykiln", {}}, {"by the book's rules", {}, true}};
  charts[2].name = "lsystem_mesh", charts[2].title = "Meshing Honda's tree, one core";
  charts[2].x = {"triangles", true}, charts[2].y = {"seconds", true};
  charts[2].series = {{"citykiln", {}}, {"RPForest", {{1.5e6, 44.9}}, true}};
  return charts;
}

void add_derivation(const lsystems::LSystem& system, int steps, std::vector<Chart>& charts) {
  lsystems::DeriveOptions options;
  options.steps = steps;
  lsystems::Derivation derivation;
  const double seconds = fastest_s([&] { derivation = lsystems::derive(system, options); });
  const auto symbols = static_cast<double>(derivation.string.kinds.size());
  charts[1].series[0].points.emplace_back(steps, symbols);
  charts[1].series[1].points.emplace_back(steps, expected_symbols(steps));
  if (steps < 6) return;
  charts[0].series[0].points.emplace_back(symbols, static_cast<double>(derivation.written) / seconds);
}

void add_mesh(const lsystems::LSystem& system, int steps, Chart& chart) {
  lsystems::DeriveOptions options;
  options.steps = steps;
  lsystems::Skeleton skeleton = lsystems::grow(system, options).skeleton;
  lsystems::TubeOptions tubes;
  // equal thickness, so that no stem is dropped and each has four sides
  for (lsystems::Segment& segment : skeleton.segments) segment.start_radius = segment.end_radius = 1e-3;
  tubes.tolerance_m = 1.5e-3;
  lsystems::PlantMesh mesh;
  const double seconds = fastest_s([&] { lsystems::mesh_plant(skeleton, tubes, mesh); });
  chart.series[0].points.emplace_back(static_cast<double>(mesh.bark.triangles.size()), seconds);
}

}  // namespace

Result<std::vector<Chart>> chart_lsystem(const ChartRequest&) {
  const Result<lsystems::LSystem> system = lsystems::read_lsystem(kHonda, "honda.lsys");
  if (!system) return system.error();
  std::vector<Chart> charts = empty_derivation_charts();
  for (int steps = 1; steps <= kMostSteps; ++steps) add_derivation(*system, steps, charts);
  for (int steps = kFewestMeshed; steps <= kMostMeshed; ++steps) add_mesh(*system, steps, charts[2]);
  const auto& symbols = charts[0].series[0].points;
  charts[0].series[1].points = {{symbols.front().first, kOthersFewest}, {symbols.back().first, kOthersFewest}};
  charts[0].series[2].points = {{symbols.front().first, kOthersMost}, {symbols.back().first, kOthersMost}};
  Series& meshing = charts[2].series[0];
  meshing.name += fmt::format(", slope {:.2f}", exponent_of(meshing));
  return charts;
}

}  // namespace citykiln::charts
