// Helpers for tests: L-systems in a line of text, and their derived strings.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "lsystems/reading/read_lsystem.h"
#include "lsystems/rewriting/derive.h"
#include "tests/test_files.h"

namespace citykiln::lsystems {

inline LSystem system_of(const std::string& text) {
  Result<LSystem> system = read_lsystem(text, "x.lsys");
  EXPECT_TRUE(system) << to_string(system.error()) << "\n" << text;
  return system ? *system : LSystem{};
}

/// Returns the string after a number of steps, as text.
inline std::string grown(const std::string& text, int steps, std::uint64_t seed = 0) {
  const LSystem system = system_of(text);
  DeriveOptions options;
  options.steps = steps;
  options.seed = seed;
  return text_of(system, derive(system, options).string);
}

/// Returns the text of a file of the source tree.
inline std::string text_of_tree(const std::string& path) {
  std::ifstream in(source_file(path));
  EXPECT_TRUE(in) << path;
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// The number of modules of each name.
inline std::map<std::string, std::uint64_t> counts_of(const LSystem& system, const ModuleString& string) {
  std::map<std::string, std::uint64_t> counts;
  for (const Kind kind : string.kinds) ++counts[system.kinds[kind].name];
  return counts;
}

}  // namespace citykiln::lsystems
