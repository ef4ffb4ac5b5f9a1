// Builds the road network and its junction outlines. For comparison: osm2streets takes 2.6 s for Chicago's Loop and 28
// s for Porto, SUMO 3.5 s and 34 s.
#include <benchmark/benchmark.h>

#include "compiler/map/locate.h"
#include "compiler/roads/junctions/junction.h"
#include "compiler/roads/roads_on_ground.h"
#include "compiler/source/read_osm.h"
#include "tests/bench/bench_data.h"

namespace citykiln::roads {
namespace {

std::vector<Road> roads_of(const std::string& path) {
  Report ignored;
  const auto osm = source::read_osm(path, 0, ignored);
  const source::LonLatBox box = map::choose_box(*osm, {});
  return roads_on_ground(map::locate(*osm, map::Plane(map::default_origin(box)), box, {}, ignored), ignored);
}

void plan_and_outline(benchmark::State& state, const std::string& name) {
  const std::string path = data_or_skip(state, name);
  if (path.empty()) return;
  const std::vector<Road> roads = roads_of(path);
  std::size_t junctions = 0;
  for (auto _ : state) {
    Report ignored;
    const std::vector<Junction> planned = plan_junctions(roads, ignored);
    benchmark::DoNotOptimize(outline_junctions(planned, roads, 0));
    junctions = planned.size();
  }
  state.counters["junctions/s"] =
      benchmark::Counter(static_cast<double>(junctions), benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK_CAPTURE(plan_and_outline, monaco, "monaco/monaco-2023.osm.pbf")->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plan_and_outline, chicago, "chicago-loop/chicago_loop.osm.pbf")
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plan_and_outline, porto, "porto-roads/porto_portugal.osm.pbf")
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace citykiln::roads
