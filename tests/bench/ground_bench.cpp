// Meshes the ground of one cell without borders: triangles and time by tolerance.
#include <benchmark/benchmark.h>

#include "compiler/ground/generate.h"
#include "tests/bench/made_hills.h"

namespace citykiln::ground {
namespace {

void generate_bare_cell(benchmark::State& state) {
  const GradedTerrain ground(made_hills());
  const double tolerance_m = static_cast<double>(state.range(0)) / 100;
  std::size_t triangles = 0;
  for (auto _ : state) {
    Report report;
    triangles = generate_cell({}, ground, {{0, 0}, {1024, 1024}}, tolerance_m, report).mesh.triangles.size();
  }
  state.counters["triangles"] = static_cast<double>(triangles);
}
BENCHMARK(generate_bare_cell)
    ->ArgName("tolerance_cm")
    ->Arg(10)
    ->Arg(50)
    ->Arg(250)
    ->Arg(1250)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace citykiln::ground
