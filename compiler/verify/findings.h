// What `check` found out: the promises, and what is stated but not judged.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "compiler/verify/measure_clearances.h"
#include "compiler/verify/measure_following.h"
#include "compiler/verify/measure_lines.h"

namespace citykiln::verify {

/// One promise, how often it was put to the test, and where it broke.
struct Finding {
  std::string promise;
  std::uint64_t tests = 0;
  std::vector<std::string> breaches;

  void test(bool holds, const std::string& breach) { test_all(1, holds, breach); }

  void test_all(std::uint64_t count, bool hold, const std::string& breach) {
    tests += count;
    if (!hold) breaches.push_back(breach);
  }
};

struct Findings {
  Finding ledger{"in + split = out + merged + dropped in every account", 0, {}};
  Finding forms{"every .glb is what the manifest bakes, byte for byte", 0, {}};
  Finding area{"the plan area of the ground's faces is the plan area of the tile", 0, {}};
  Finding height{"the ground is nowhere farther from its heights than error_m", 0, {}};
  Finding seams{"neighbouring tiles have the same border edges", 0, {}};
  Finding jumps{"roads, bridges and tunnels meet at the same height, to 1 cm", 0, {}};
  Finding roads{"the ground is nowhere farther from a road's profile than error_m", 0, {}};
  Finding rivers{"no river rises", 0, {}};
  Finding lakes{"standing water is level", 0, {}};
  Finding footing{"under no corner of a building is a gap over 5 cm, or over error_m where that is more", 0, {}};
  Finding trunks{"no trunk stands in a road, a rail, a building or water", 0, {}};
  // stated, not judged
  Grades grades;
  Following following;
  Clearances clearances;
};

std::vector<const Finding*> all_of(const Findings& findings);

/// Counts what a tile was found to be to what is known of others; its breaches come after theirs.
void add(Findings& findings, const Findings& of_tile);

}  // namespace citykiln::verify
