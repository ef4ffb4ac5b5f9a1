// Real data for benchmarks. A benchmark whose data are missing is skipped with a message.
#pragma once

#include <benchmark/benchmark.h>

#include <filesystem>
#include <string>

#include "tests/test_files.h"

namespace citykiln {

/// The path of a file in ../shared/data; empty if it is missing, and then the benchmark is marked as skipped.
inline std::string data_or_skip(benchmark::State& state, const std::string& name) {
  const std::string path = real_data(name);
  if (std::filesystem::exists(path)) return path;
  state.SkipWithError(("missing: " + path).c_str());
  return {};
}

}  // namespace citykiln
