// Generates roofs: each form over a rectangle, and straight skeletons in doubles and in exact numbers over real
// footprints.
#include <benchmark/benchmark.h>

#include "bench_data.h"
#include "compiler/map/locate.h"
#include "compiler/source/read_osm.h"
#include "grammars/roofs/generate_roof.h"

namespace citykiln::roofs {
namespace {

std::vector<Polygon> footprints_of(const std::string& path) {
  Report report;
  const auto osm = source::read_osm(path, 1, report);
  if (!osm) return {};
  const source::LonLatBox box = map::choose_box(*osm, {});
  const map::Plane plane(map::default_origin(box));
  std::vector<Polygon> polygons;
  for (const map::Footprint& f : map::locate(*osm, plane, box, {}, report).footprints) polygons.push_back(f.polygon);
  return polygons;
}

// One detached house; needs no skeleton.
void RoofOverARectangle(benchmark::State& state) {
  RoofShape shape;
  shape.form = static_cast<RoofForm>(state.range(0));
  const Polygon house{{{0, 0}, {12, 0}, {12, 9}, {0, 9}}, {}};
  Report report;
  for (auto _ : state) benchmark::DoNotOptimize(generate_roof(house, shape, 0.02, {}, report));
  state.SetLabel(std::string(name_of(shape.form)));
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(RoofOverARectangle)->DenseRange(0, static_cast<int>(RoofForm::kCount) - 1)->Unit(benchmark::kMicrosecond);

// Hipped roofs on all buildings of a town, by the skeleton alone: helsinki has an old town's shapes, reinickendorf many
// houses.
void HippedBySkeleton(benchmark::State& state, const std::string& file, SkeletonKernel kernel) {
  const std::string path = data_or_skip(state, file);
  if (path.empty()) return;
  const std::vector<Polygon> polygons = footprints_of(path);
  RoofShape shape;
  shape.form = RoofForm::kHipped;
  std::size_t failures = 0;
  for (auto _ : state) {
    failures = 0;
    for (const Polygon& polygon : polygons) failures += !roof_by_skeleton(polygon, shape, 0.02, kernel);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(polygons.size()));
  state.counters["roofs"] = static_cast<double>(polygons.size());
  state.counters["failures"] = static_cast<double>(failures);
}
BENCHMARK_CAPTURE(HippedBySkeleton, helsinki_inexact, "helsinki/Helsinki.osm.pbf", SkeletonKernel::kInexact);
BENCHMARK_CAPTURE(HippedBySkeleton, helsinki_exact, "helsinki/Helsinki.osm.pbf", SkeletonKernel::kExact);
BENCHMARK_CAPTURE(HippedBySkeleton, reinickendorf_inexact, "berlin/berlin-reinickendorf-2026.osm.pbf",
                  SkeletonKernel::kInexact);
BENCHMARK_CAPTURE(HippedBySkeleton, reinickendorf_exact, "berlin/berlin-reinickendorf-2026.osm.pbf",
                  SkeletonKernel::kExact);

}  // namespace
}  // namespace citykiln::roofs
