// Real data for benchmarks; what is absent is skipped with a message.
#pragma once

#include <benchmark/benchmark.h>

#include <filesystem>
#include <string>

namespace citykiln {

/// Where ../shared/data has a file, or nothing, in which case the benchmark is marked as skipped.
inline std::string data_or_skip(benchmark::State& state, const std::string& name) {
  const std::string path = std::string(CITYKILN_DATA) + "/" + name;
  if (std::filesystem::exists(path)) return path;
  state.SkipWithError(("absent: " + path).c_str());
  return {};
}

}  // namespace citykiln
