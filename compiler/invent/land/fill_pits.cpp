#include "compiler/invent/land/fill_pits.h"

#include <queue>
#include <utility>

namespace citykiln::invent {

void fill_pits(Lattice& lattice) {
  // lowest first; equal heights in the order of points
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  std::vector<bool> is_reached(lattice.size(), false);
  for (std::size_t i = 0; i < lattice.size(); ++i)
    if (lattice.is_on_border(i)) open.emplace(lattice.heights_m[i], i), is_reached[i] = true;
  while (!open.empty()) {
    const auto [height_m, i] = open.top();
    open.pop();
    lattice.for_each_neighbour(i, [&, least_m = height_m + kPitFall_m](std::size_t j, double) {
      if (is_reached[j]) return;
      is_reached[j] = true;
      if (lattice.heights_m[j] < least_m) lattice.heights_m[j] = least_m;
      open.emplace(lattice.heights_m[j], j);
    });
  }
}

}  // namespace citykiln::invent
