// Measures triangles of a coarse mesh against the terrain and against a reference with the same heights.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

#include "compiler/ground/mesh/height_error.h"
#include "tests/bench/made_hills.h"
#include "tests/compiler/ground/mesh/made_references.h"

namespace citykiln::ground {
namespace {

// A mesh during refinement: right triangles of this width, off the grid's lines, jittered.
std::vector<std::array<Vec3, 3>> triangles(double width_m) {
  std::vector<std::array<Vec3, 3>> all;
  const RandomSequence draw(1, StableId{1}, "jitter");
  const int count = static_cast<int>(1000 / width_m);
  const auto corner = [&](int i, int j) {
    const auto index = static_cast<std::uint32_t>(2 * (i + j * (count + 1)));
    // within the hills, which are 1,024 m wide
    return Vec3{std::min(1020.0, std::floor(4 + i * width_m + draw.unit(index) * width_m / 4)),
                std::min(1020.0, std::floor(4 + j * width_m + draw.unit(index + 1) * width_m / 4)), 20};
  };
  for (int j = 0; j < count; ++j)
    for (int i = 0; i < count; ++i) {
      all.push_back({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)});
      all.push_back({corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)});
    }
  return all;
}

template <typename Inside, typename Edge>
void measure(benchmark::State& state, Inside inside, Edge edge) {
  const auto mesh = triangles(static_cast<double>(state.range(0)));
  for (auto _ : state)
    for (const auto& corners : mesh) {
      benchmark::DoNotOptimize(inside(corners));
      for (int i = 0; i < 3; ++i) benchmark::DoNotOptimize(edge(corners[i], corners[(i + 1) % 3]));
    }
  state.counters["triangles/s"] =
      benchmark::Counter(static_cast<double>(mesh.size() * state.iterations()), benchmark::Counter::kIsRate);
}

void measure_by_field(benchmark::State& state) {
  const map::Heightfield field = made_hills();
  measure(
      state, [&](const auto& corners) { return worst_inside(field, corners); },
      [&](Vec3 a, Vec3 b) { return worst_on_edge(field, a, b); });
}

void measure_by_reference(benchmark::State& state) {
  const Reference reference = reference_of_field(made_hills());
  measure(
      state, [&](const auto& corners) { return worst_inside(reference, corners, HeightLayer::kLand); },
      [&](Vec3 a, Vec3 b) { return worst_on_edge(reference, a, b, HeightLayer::kLand); });
}

void heights_by_reference(benchmark::State& state) {
  const Reference reference = reference_of_field(made_hills());
  const RandomSequence draw(1, StableId{1}, "places");
  std::uint32_t i = 0;
  for (auto _ : state) {
    const Vec2 p{draw.between(0, 1024, i), draw.between(0, 1024, i + 1)};
    i += 2;
    benchmark::DoNotOptimize(height_m_at(reference, p, HeightLayer::kLand));
  }
}

BENCHMARK(measure_by_field)->ArgName("width_m")->Arg(4)->Arg(16)->Arg(64)->Arg(250)->Unit(benchmark::kMillisecond);
BENCHMARK(measure_by_reference)->ArgName("width_m")->Arg(4)->Arg(16)->Arg(64)->Arg(250)->Unit(benchmark::kMillisecond);
BENCHMARK(heights_by_reference);

}  // namespace
}  // namespace citykiln::ground
