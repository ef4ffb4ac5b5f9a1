// Derives houses by whole rule files, from footprint to terminals, at the tolerances of the levels. Goal: 3 million
// triangles per second and core at level 0, and less time at coarser levels.
#include <benchmark/benchmark.h>

#include <fstream>
#include <sstream>

#include "grammars/derivation/derive.h"
#include "grammars/language/read_rules.h"
#include "tests/test_files.h"

namespace citykiln::grammars {
namespace {

Result<std::string> file_at(const std::string& path) {
  std::ifstream in(path);
  if (!in) return Error{path, "cannot be read"};
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

Result<std::string> beside(const std::string& file) { return file_at(source_file("tests/" + file)); }

/// The input of one derivation.
struct House {
  Result<Program> program;
  double width_m, depth_m;
  DeriveOptions options;
};

// A house of an old town: a shop, and five floors of windows with reveals, frames and sills. No roof; see
// roof_bench.cpp.
House old_town() {
  House house{read_rules("grammars/town_house.cga", beside), 18, 12, {}};
  house.options.attributes = {{"height", 21.0}, {"levels", 6.0}};
  return house;
}

// Ten floors of windows, and of balconies with railings.
House flats() { return {read_rules("bench/flats.cga", beside), 24, 14, {}}; }

std::uint64_t triangles_of_derivation(const Derivation& derivation) {
  std::uint64_t triangles = 0;
  // a polygon of n points has n - 2 triangles, and two more for each hole
  for (const Terminal& terminal : derivation.terminals)
    for (const Face& face : terminal.faces) triangles += vertex_count({&face, 1}) - 2 + 2 * face.holes.size();
  return triangles;
}

void derive_houses(benchmark::State& state, House house) {
  if (!house.program) return state.SkipWithError(to_string(house.program.error()).c_str());
  const Polygon footprint{{{0, 0}, {house.width_m, 0}, {house.width_m, house.depth_m}, {0, house.depth_m}}, {}};
  house.options.roofs = [](const RoofRequest&) { return std::optional<std::vector<Face>>(); };
  house.options.tolerance_m = static_cast<double>(state.range(0)) / 1000;
  house.options.memoise = state.range(1) > 0;
  house.options.prune_early = state.range(1) > 1;
  std::uint64_t houses = 0, triangles = 0;
  for (auto _ : state) {
    const Shape first = lot(footprint, 0, 0, StableId{++houses}, {0});
    triangles += triangles_of_derivation(derive(*house.program, first, house.options));
  }
  state.counters["triangles"] = static_cast<double>(triangles) / static_cast<double>(houses);
  state.counters["triangles/s"] = benchmark::Counter(static_cast<double>(triangles), benchmark::Counter::kIsRate);
  state.counters["houses/s"] = benchmark::Counter(static_cast<double>(houses), benchmark::Counter::kIsRate);
}

void derive_old_town(benchmark::State& state) { derive_houses(state, old_town()); }
void derive_flats(benchmark::State& state) { derive_houses(state, flats()); }

void read_house(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(read_rules("grammars/town_house.cga", beside));
}

// tolerance in millimetres; saves: 0 nothing, 1 memoise, 2 prune_early too
const std::vector<std::vector<std::int64_t>> kLevels = {{0, 100, 500, 2500}, {0, 1, 2}};
BENCHMARK(derive_old_town)->ArgNames({"mm", "saves"})->ArgsProduct(kLevels)->Unit(benchmark::kMillisecond);
BENCHMARK(derive_flats)->ArgNames({"mm", "saves"})->ArgsProduct(kLevels)->Unit(benchmark::kMillisecond);
BENCHMARK(read_house);

}  // namespace
}  // namespace citykiln::grammars
