// A house of a rule file of some size, from its footprint to its terminals: L0 is to give 3 million triangles a second
// and core.
#include <benchmark/benchmark.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "grammars/derive.h"
#include "grammars/link.h"

namespace citykiln::grammars {
namespace {

Result<std::string> beside(const std::string& file) {
  std::ifstream in(std::filesystem::path(__FILE__).parent_path() / "../grammars" / file);
  if (!in) return Error{file, "cannot be read"};
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

void derive_house(benchmark::State& state) {
  const auto program = read_rules("town_house.cga", beside);
  const Polygon footprint{{{0, 0}, {11, 0}, {11, 9}, {0, 9}}, {}};
  DeriveOptions options;
  options.tolerance_m = static_cast<double>(state.range(0)) / 1000;
  std::uint64_t houses = 0, shapes = 0, triangles = 0;
  for (auto _ : state) {
    const Derivation derivation = derive(*program, lot(footprint, 0, 0, StableId{++houses}, {0}), options);
    shapes += derivation.shapes;
    // a polygon of n points is n - 2 triangles, two more for each hole
    for (const Terminal& terminal : derivation.terminals)
      for (const Face& face : terminal.faces) triangles += vertex_count({&face, 1}) - 2 + 2 * face.holes.size();
  }
  state.counters["shapes/s"] = benchmark::Counter(static_cast<double>(shapes), benchmark::Counter::kIsRate);
  state.counters["triangles/s"] = benchmark::Counter(static_cast<double>(triangles), benchmark::Counter::kIsRate);
  state.counters["houses/s"] = benchmark::Counter(static_cast<double>(houses), benchmark::Counter::kIsRate);
}

void read_house(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(read_rules("town_house.cga", beside));
}

// tolerances in millimetres
BENCHMARK(derive_house)->Arg(0)->Arg(100)->Arg(500)->Arg(2500);
BENCHMARK(read_house);

}  // namespace
}  // namespace citykiln::grammars
