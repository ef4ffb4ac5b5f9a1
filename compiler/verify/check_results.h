// What `check` found out: the promises, and what is stated but not judged.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "compiler/verify/measure_clearances.h"
#include "compiler/verify/measure_lines.h"
#include "compiler/verify/measure_reference_error.h"

namespace citykiln::verify {

/// One promise, how often it was put to the test, and where it broke.
struct Check {
  std::string claim;
  std::uint64_t tests = 0;
  std::vector<std::string> failures;

  void test(bool holds, const std::string& failure) { test_all(1, holds, failure); }

  void test_all(std::uint64_t count, bool hold, const std::string& failure) {
    tests += count;
    if (!hold) failures.push_back(failure);
  }
};

struct CheckResults {
  Check ledger{"in + split = out + merged + dropped in every account", 0, {}};
  Check glb_bytes{"every .glb is what the manifest bakes, byte for byte", 0, {}};
  Check area{"the plan area of the ground's faces is the plan area of the tile", 0, {}};
  Check height{"the ground is nowhere farther from its heights than error_m", 0, {}};
  Check seams{"neighbouring tiles have the same border edges", 0, {}};
  Check jumps{"roads, bridges and tunnels meet at the same height, to 1 cm", 0, {}};
  Check roads{"the ground is nowhere farther from a road's profile than error_m", 0, {}};
  Check rivers{"no river rises", 0, {}};
  Check lakes{"standing water is level", 0, {}};
  Check footing{"under no corner of a building is a gap over 5 cm, or over error_m where that is more", 0, {}};
  Check trunks{"no trunk stands in a road, a rail, a building or water", 0, {}};
  // stated, not judged
  Grades grades;
  ReferenceErrors reference_errors;
  Clearances clearances;
};

std::vector<const Check*> all_of(const CheckResults& results);

/// Counts what a tile was found to be to what is known of others; its breaches come after theirs.
void add(CheckResults& results, const CheckResults& of_tile);

}  // namespace citykiln::verify
