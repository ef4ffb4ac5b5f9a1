// Plans all buildings of a real town and generates their meshes at the tolerances of the levels. Unlike
// houses_bench.cpp this includes reuse between equal parts of a town, and the cost of irregular footprints.
#include <benchmark/benchmark.h>

#include "compiler/buildings/generate.h"
#include "compiler/buildings/plan.h"
#include "compiler/contract/system/for_each_slot.h"
#include "compiler/map/locate.h"
#include "compiler/source/read_osm.h"
#include "tests/bench/bench_data.h"

namespace citykiln::buildings {
namespace {

constexpr const char* kTown = "neubrandenburg/neubrandenburg.osm.bz2";

map::Features features_of(benchmark::State& state, const std::string& name) {
  Report report;
  const auto osm = source::read_osm(data_or_skip(state, name), 2, report);
  if (!osm) return {};
  const source::LonLatBox box = map::choose_box(*osm, {});
  return map::locate(*osm, map::Plane(map::default_origin(box)), box, {}, report);
}

ground::GradedTerrain level_ground() {
  return ground::GradedTerrain(map::Heightfield{{-64, -64}, {64, 64}, 3, 3, std::vector<std::int32_t>(9), 0});
}

void plan_town(benchmark::State& state) {
  const map::Features features = features_of(state, kTown);
  const ground::GradedTerrain ground = level_ground();
  std::size_t buildings = 0;
  for (auto _ : state) {
    Report report;
    buildings = plan(features, ground, report).size();
  }
  state.counters["buildings"] = static_cast<double>(buildings);
}

std::uint64_t triangles_of_building(const GeneratedBuilding& house) {
  std::uint64_t triangles = 0;
  for (const auto& dressed : house.meshes) triangles += dressed.mesh.triangles.size();
  for (const auto& textured_faces : house.textured_faces) triangles += textured_faces.mesh.mesh.triangles.size();
  return triangles;
}

// The town's buildings, planned once for all benchmarks of a run.
const std::vector<Building>& town(benchmark::State& state) {
  static const std::vector<Building> buildings = [&] {
    Report report;
    return plan(features_of(state, kTown), level_ground(), report);
  }();
  return buildings;
}

void generate_town(benchmark::State& state) {
  const std::vector<Building>& all = town(state);
  const double tolerance_m = static_cast<double>(state.range(0)) / 1000;
  const auto one_in = static_cast<std::size_t>(state.range(1));
  const std::size_t count = all.size() / one_in;
  std::uint64_t triangles = 0;
  for (auto _ : state) {
    const Rulebook rulebook = parse_rulebook(shipped_rules());
    const auto made = for_each_slot<std::uint64_t>(count, static_cast<int>(state.range(2)), [&](std::size_t i) {
      Report report;
      return triangles_of_building(generate(all[i * one_in], rulebook, {1}, tolerance_m, report));
    });
    for (const std::uint64_t each : made) triangles += each;
  }
  state.counters["triangles"] = static_cast<double>(triangles) / static_cast<double>(state.iterations());
  state.counters["triangles/s"] = benchmark::Counter(static_cast<double>(triangles), benchmark::Counter::kIsRate);
}

BENCHMARK(plan_town)->Unit(benchmark::kMillisecond);
// tolerance in millimetres; one building in this many; threads
BENCHMARK(generate_town)
    ->ArgNames({"mm", "one_in", "threads"})
    ->ArgsProduct({{20, 100, 500, 2500}, {16}, {1}})
    ->Args({20, 1, 1})
    ->Args({100, 1, 2})
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace citykiln::buildings
