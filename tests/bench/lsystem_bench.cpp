// Derives plants to strings, skeletons and meshes. Goals: Honda's tree at n = 15 at 40 million symbols per second and
// core (RPForest: 12 to 17 million), and 1.5 million triangles in 0.1 s (RPForest: 44.9 s). Figures are of
// Prusinkiewicz and Lindenmayer, The Algorithmic Beauty of Plants.
#include <benchmark/benchmark.h>

#include <fstream>
#include <sstream>

#include "lsystems/mesh/tubes.h"
#include "lsystems/reading/read_lsystem.h"
#include "lsystems/rewriting/derive.h"
#include "lsystems/rewriting/turtle.h"

namespace citykiln::lsystems {
namespace {

// figure 2.6 a
constexpr const char* kHonda = R"(
#define r1 0.9
#define r2 0.6
#define a0 45
#define a2 45
#define d 137.5
#define wr 0.707
axiom: A(1,10)
p1: A(l,w) : * -> !(w)F(l)[&(a0)B(l*r2,w*wr)]/(d)A(l*r1,w*wr)
p2: B(l,w) : * -> !(w)F(l)[-(a2)$C(l*r2,w*wr)]C(l*r1,w*wr)
p3: C(l,w) : * -> !(w)F(l)[+(a2)$B(l*r2,w*wr)]B(l*r1,w*wr)
)";

// figure 1.24 e: no parameters, every F doubles
constexpr const char* kBush = "axiom: X\nX -> F[+X][-X]FX\nF -> FF\n";

// figure 1.27: stochastic
constexpr const char* kChance = "axiom: F\nF -> (0.33) F[+F]F[-F]F\nF -> (0.33) F[+F]F\nF -> (0.34) F[-F]F\n";

// figure 1.31 a, by Hogeweg and Hesper: contexts on both sides
constexpr const char* kContexts = R"(
#ignore: +-F
axiom: F1F1F1
0 < 0 > 0 -> 0
0 < 0 > 1 -> 1[+F1F1]
0 < 1 > 0 -> 1
0 < 1 > 1 -> 1
1 < 0 > 0 -> 0
1 < 0 > 1 -> 1F1
1 < 1 > 0 -> 0
1 < 1 > 1 -> 0
+ -> -
- -> +
)";

void derive_system(benchmark::State& state, const char* text) {
  const Result<LSystem> system = read_lsystem(text, "bench.lsys");
  if (!system) return state.SkipWithError(to_string(system.error()).c_str());
  DeriveOptions options;
  options.steps = static_cast<int>(state.range(0));
  std::uint64_t written = 0, symbols = 0, rounds = 0;
  for (auto _ : state) {
    const Derivation derivation = derive(*system, options);
    if (derivation.limit_exceeded) return state.SkipWithError(limit_line(*system, *derivation.limit_exceeded).c_str());
    written += derivation.written;
    symbols = derivation.string.kinds.size();
    ++rounds;
  }
  state.counters["symbols"] = static_cast<double>(symbols);
  state.counters["symbols/s"] = benchmark::Counter(static_cast<double>(written), benchmark::Counter::kIsRate);
}

void walk_system(benchmark::State& state, const char* text) {
  const Result<LSystem> system = read_lsystem(text, "bench.lsys");
  if (!system) return state.SkipWithError(to_string(system.error()).c_str());
  DeriveOptions options;
  options.steps = static_cast<int>(state.range(0));
  const ModuleString string = derive(*system, options).string;
  std::uint64_t walked = 0, segments = 0;
  for (auto _ : state) {
    segments += walk(*system, string).segments.size();
    walked += string.kinds.size();
  }
  state.counters["symbols/s"] = benchmark::Counter(static_cast<double>(walked), benchmark::Counter::kIsRate);
  state.counters["segments/s"] = benchmark::Counter(static_cast<double>(segments), benchmark::Counter::kIsRate);
}

// time must be linear in the number of segments
void mesh_system(benchmark::State& state, double tolerance_m) {
  const Result<LSystem> system = read_lsystem(kHonda, "bench.lsys");
  DeriveOptions options;
  options.steps = static_cast<int>(state.range(0));
  Skeleton skeleton = walk(*system, derive(*system, options).string);
  // one thickness everywhere, so that every segment is drawn with the same number of sides
  for (Segment& segment : skeleton.segments) segment.start_radius = segment.end_radius = 0.05;
  TubeOptions tubes;
  tubes.tolerance_m = tolerance_m;
  // allocates the memory before the timed loop
  PlantMesh mesh = mesh_plant(skeleton, tubes);
  for (auto _ : state) mesh_plant(skeleton, tubes, mesh);
  const auto triangles = static_cast<double>(mesh.bark.triangles.size());
  state.SetComplexityN(static_cast<benchmark::IterationCount>(mesh.bark.triangles.size()));
  state.counters["triangles"] = triangles;
  state.counters["error_m"] = mesh.error_m;
  state.counters["triangles/s"] = benchmark::Counter(triangles, benchmark::Counter::kIsIterationInvariantRate);
}

void read_system(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(read_lsystem(kHonda, "bench.lsys"));
}

BENCHMARK_CAPTURE(derive_system, honda, kHonda)->Arg(10)->Arg(15)->Arg(18)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(derive_system, bush, kBush)->Arg(7)->Arg(9)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(derive_system, chance, kChance)->Arg(8)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(derive_system, contexts, kContexts)->Arg(30)->Arg(45)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(walk_system, honda, kHonda)->Arg(10)->Arg(15)->Arg(18)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(mesh_system, joints, 0.01)
    ->DenseRange(9, 17, 2)
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oN);
BENCHMARK_CAPTURE(mesh_system, fine_joints, 0.003)
    ->DenseRange(9, 15, 2)
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oN);
BENCHMARK(read_system);

}  // namespace
}  // namespace citykiln::lsystems
