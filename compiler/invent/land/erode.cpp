#include "compiler/invent/land/erode.h"

#include <cmath>

#include "compiler/invent/land/drainage.h"
#include "compiler/invent/land/fill_pits.h"

namespace citykiln::invent {
namespace {

bool stays(const std::vector<bool>& is_fixed, std::size_t i) { return !is_fixed.empty() && is_fixed[i]; }

void incise(Lattice& lattice, double strength, const std::vector<bool>& is_fixed) {
  const Drainage drainage = drain(lattice);
  for (const std::uint32_t i : drainage.order) {
    const std::uint32_t r = drainage.receiver[i];
    if (r == i || stays(is_fixed, i)) continue;
    const bool is_diagonal = lattice.column(i) != lattice.column(r) && lattice.row(i) != lattice.row(r);
    const double run_m = lattice.step_m * (is_diagonal ? 1.4142135623730951 : 1);
    const double factor = strength * std::sqrt(drainage.area_m2[i]) / run_m;
    lattice.heights_m[i] = (lattice.heights_m[i] + factor * lattice.heights_m[r]) / (1 + factor);
  }
}

void creep(Lattice& lattice, double share, const std::vector<bool>& is_fixed) {
  const std::vector<double> before = lattice.heights_m;
  const int count = lattice.count();
  for (int row = 1; row < lattice.cells; ++row)
    for (int column = 1; column < lattice.cells; ++column) {
      const std::size_t i = lattice.index(column, row);
      if (stays(is_fixed, i)) continue;
      const double mean = (before[i - 1] + before[i + 1] + before[i - count] + before[i + count]) / 4;
      lattice.heights_m[i] += share * (mean - before[i]);
    }
}

}  // namespace

void erode(Lattice& lattice, const Erosion& settings, const std::vector<bool>& is_fixed) {
  for (int step = 0; step < settings.steps; ++step) {
    fill_pits(lattice);
    incise(lattice, settings.strength, is_fixed);
    creep(lattice, settings.creep, is_fixed);
  }
  fill_pits(lattice);
}

}  // namespace citykiln::invent
