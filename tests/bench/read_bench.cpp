// Reads extracts, compared with `osmium fileinfo -e`, which decodes every element once.
#include <benchmark/benchmark.h>

#include <cstdlib>

#include "compiler/source/format/decode_osm.h"
#include "compiler/source/read_osm.h"
#include "tests/bench/bench_data.h"

namespace citykiln::source {
namespace {

void osmium_fileinfo(benchmark::State& state, const std::string& name) {
  const std::string path = data_or_skip(state, name);
  const std::string command = "osmium fileinfo -e '" + path + "' >/dev/null";
  for (auto _ : state)
    if (std::system(command.c_str()) != 0) return state.SkipWithError("osmium fileinfo failed");
}

void decode(benchmark::State& state, const std::string& name) {
  const std::string path = data_or_skip(state, name);
  for (auto _ : state) benchmark::DoNotOptimize(decode_osm(path, 0));
}

// Everything citykiln reads from a file, with node locations and areas.
void read_all(benchmark::State& state, const std::string& name) {
  const std::string path = data_or_skip(state, name);
  for (auto _ : state) {
    Report report;
    benchmark::DoNotOptimize(read_osm(path, 0, report));
  }
}

#define CITYKILN_READ(name, file)                                                               \
  BENCHMARK_CAPTURE(osmium_fileinfo, name, file)->UseRealTime()->Unit(benchmark::kMillisecond); \
  BENCHMARK_CAPTURE(decode, name, file)->UseRealTime()->Unit(benchmark::kMillisecond);          \
  BENCHMARK_CAPTURE(read_all, name, file)->UseRealTime()->Unit(benchmark::kMillisecond)

CITYKILN_READ(andorra_pbf, "andorra/andorra-2023.osm.pbf");
CITYKILN_READ(chicago_pbf, "chicago-loop/chicago_loop.osm.pbf");
CITYKILN_READ(helsinki_pbf, "helsinki/Helsinki.osm.pbf");
CITYKILN_READ(monaco_pbf, "monaco/monaco-2023.osm.pbf");
CITYKILN_READ(reinickendorf_pbf, "berlin/berlin-reinickendorf-2026.osm.pbf");
CITYKILN_READ(neukolln_xml, "berlin/berlin-neukolln.osm");
CITYKILN_READ(neubrandenburg_bz2, "neubrandenburg/neubrandenburg.osm.bz2");

}  // namespace
}  // namespace citykiln::source
