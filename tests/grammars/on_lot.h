// Rules applied to small lots, for tests.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "grammars/derivation/derive.h"
#include "grammars/language/read_rules.h"

namespace citykiln::grammars {

inline Program program_of(const std::string& text) {
  Result<Program> program = read_rules_of(text, "test.cga");
  EXPECT_TRUE(program) << to_string(program.error());
  return program ? std::move(*program) : Program{};
}

inline Polygon rectangle(double width_m, double depth_m) {
  return {{{0, 0}, {width_m, 0}, {width_m, depth_m}, {0, depth_m}}, {}};
}

/// A lot of this size whose edge 0 (the front, to the south) is along the street.
inline Shape lot_of(double width_m, double depth_m, std::uint64_t id = 1) {
  return lot(rectangle(width_m, depth_m), 0, 0, StableId{id}, {0});
}

inline Derivation derived(const std::string& text, double width_m = 10, double depth_m = 8,
                          DeriveOptions options = {}) {
  return derive(program_of(text), lot_of(width_m, depth_m), options);
}

inline std::size_t count_named(const Derivation& derivation, const std::string& name) {
  std::size_t count = 0;
  for (const Terminal& terminal : derivation.terminals) count += terminal.name == name;
  return count;
}

inline std::vector<const Terminal*> named(const Derivation& derivation, const std::string& name) {
  std::vector<const Terminal*> found;
  for (const Terminal& terminal : derivation.terminals)
    if (terminal.name == name) found.push_back(&terminal);
  return found;
}

inline double area_m2_of(const Derivation& derivation, const std::string& name) {
  double sum = 0;
  for (const Terminal* terminal : named(derivation, name))
    for (const Face& face : terminal->faces) sum += area_m2(face);
  return sum;
}

/// The first warning as a line; "" if there is none.
inline std::string first_warning(const std::string& text) {
  const Program program = program_of(text);
  const Derivation derivation = derive(program, lot_of(10, 8), {});
  return derivation.warnings.empty() ? "" : warning_line(program, derivation.warnings.front());
}

}  // namespace citykiln::grammars
