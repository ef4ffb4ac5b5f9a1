// Meshes the ground of one cell without borders: triangles and time by tolerance.
#include <benchmark/benchmark.h>

#include <cmath>

#include "compiler/ground/generate.h"

namespace citykiln::ground {
namespace {

// Hills of three wavelengths on 8 m squares; cells of 1,024 m.
map::Heightfield hills() {
  map::Heightfield field{{0, 0}, {8, 8}, 129, 129, {}};
  for (int j = 0; j < field.rows; ++j)
    for (int i = 0; i < field.columns; ++i) {
      const double metres = 40 * std::sin(i * 0.05) + 12 * std::cos(j * 0.17) + 3 * std::sin(i * 0.7 + j * 0.5);
      field.heights.push_back(static_cast<std::int32_t>(metres / map::kHeightQuantum_m));
    }
  return field;
}

void generate_bare_cell(benchmark::State& state) {
  const GradedTerrain ground(hills());
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
