// Ground with roads, water and borders: Canillo, a mountain village with a river.
#include <benchmark/benchmark.h>

#include <algorithm>

#include "compiler/bake/ground/ground_cells.h"
#include "compiler/contract/random_sequence.h"
#include "compiler/ground/profiles/plan_profiles.h"
#include "compiler/map/heights/resample.h"
#include "compiler/map/locate.h"
#include "compiler/pipeline.h"
#include "compiler/roads/roads_on_ground.h"
#include "compiler/scene/graded_terrain.h"
#include "compiler/scene/land_cover.h"
#include "compiler/source/read_osm.h"
#include "compiler/source/read_raster.h"
#include "compiler/source/voids/fill_gaps.h"
#include "tests/bench/bench_data.h"

namespace citykiln {
namespace {

constexpr const char* kVillage = "andorra/cut-canillo-village.osm.pbf";
constexpr const char* kHeights = "andorra/N42E001.hgt";

const scene::Scene& village(const std::string& map, const std::string& dem) {
  static const scene::Scene scene = [&] {
    CompileSpec spec;
    spec.map_path = map;
    spec.rasters = {*source::parse_raster_spec(dem)};
    return compile(spec, [](std::string_view, double) {})->scene;
  }();
  return scene;
}

/// The tile with the most roads.
const scene::Chunk& busiest(const scene::Scene& scene) {
  return *std::ranges::max_element(scene.chunks, {}, [](const scene::Chunk& chunk) { return chunk.roads.size(); });
}

void ground_of_a_tile(benchmark::State& state) {
  const std::string map = data_or_skip(state, kVillage), dem = data_or_skip(state, kHeights);
  if (map.empty() || dem.empty()) return;
  const scene::Scene& scene = village(map, dem);
  const scene::Chunk& chunk = busiest(scene);
  const double tolerance_m = static_cast<double>(state.range(0)) / 100;
  std::size_t triangles = 0;
  for (auto _ : state) {
    Report report;
    const ground::GradedTerrain graded = scene::graded_terrain_of(scene.header, chunk, tolerance_m);
    const scene::LandCover cover = scene::land_cover_of(scene.header, chunk, tolerance_m);
    triangles = 0;
    for (const auto& cell :
         bake::generate_cells(graded, cover.surfaces, scene::box_of(scene.header, chunk.tile), tolerance_m, 1, report))
      triangles += cell.mesh.triangles.size();
  }
  state.counters["triangles"] = static_cast<double>(triangles);
}

void graded_heights(benchmark::State& state) {
  const std::string map = data_or_skip(state, kVillage), dem = data_or_skip(state, kHeights);
  if (map.empty() || dem.empty()) return;
  const scene::Scene& scene = village(map, dem);
  const scene::Chunk& chunk = busiest(scene);
  const ground::GradedTerrain graded = scene::graded_terrain_of(scene.header, chunk, 0.1);
  const Box2 box = scene::box_of(scene.header, chunk.tile);
  const RandomSequence draw(1, StableId{1}, "places");
  std::uint32_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        heights_at(graded, {draw.between(box.min.x, box.max.x, i), draw.between(box.min.y, box.max.y, i + 1)}));
    i += 2;
  }
  state.counters["heights/s"] =
      benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

void profiles_of_a_country(benchmark::State& state) {
  const std::string path = data_or_skip(state, "andorra/andorra-2023.osm.pbf"), dem = data_or_skip(state, kHeights);
  if (path.empty() || dem.empty()) return;
  Report report;
  const source::OsmData osm = *source::read_osm(path, 1, report);
  const source::LonLatBox box = map::choose_box(osm, {});
  const map::Plane plane(map::default_origin(box));
  const map::Features features = map::locate(osm, plane, box, {}, report);
  std::vector<source::Raster> rasters;
  rasters.push_back(source::fill_voids(*source::read_raster(*source::parse_raster_spec(dem), nullptr), report));
  const map::Heightfield heights = *map::resample(rasters, plane, features.extent, report);
  const std::vector<roads::Road> roads = roads::roads_on_ground(features, report);
  const std::vector<roads::Junction> junctions = roads::plan_junctions(roads, report);
  for (auto _ : state)
    benchmark::DoNotOptimize(ground::plan_profiles(features, roads, junctions, {}, {}, heights, report));
  state.counters["roads"] = static_cast<double>(roads.size());
}

BENCHMARK(ground_of_a_tile)
    ->ArgName("tolerance_cm")
    ->Arg(2)
    ->Arg(10)
    ->Arg(50)
    ->Arg(250)
    ->Arg(1250)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(graded_heights);
BENCHMARK(profiles_of_a_country)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace citykiln
