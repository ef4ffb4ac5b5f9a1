#include "compiler/invent/land/drainage.h"

namespace citykiln::invent {
namespace {

std::uint32_t steepest_descent(const Lattice& lattice, std::size_t i) {
  std::size_t receiver = i;
  if (lattice.is_on_border(i)) return static_cast<std::uint32_t>(i);
  double steepest = 0;
  lattice.for_each_neighbour(i, [&](std::size_t j, double steps) {
    const double fall = (lattice.heights_m[i] - lattice.heights_m[j]) / steps;
    if (fall > steepest) steepest = fall, receiver = j;
  });
  return static_cast<std::uint32_t>(receiver);
}

/// All points, each after its receiver: donors are visited from the outlets upstream.
std::vector<std::uint32_t> upstream_order(const std::vector<std::uint32_t>& receiver) {
  std::vector<std::uint32_t> first(receiver.size() + 1, 0), donors(receiver.size()), order;
  for (const std::uint32_t r : receiver) ++first[r + 1];
  for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  for (std::uint32_t i = 0; i < receiver.size(); ++i) donors[next[receiver[i]]++] = i;
  order.reserve(receiver.size());
  for (std::uint32_t i = 0; i < receiver.size(); ++i)
    if (receiver[i] == i) order.push_back(i);
  for (std::size_t at = 0; at < order.size(); ++at) {
    const std::uint32_t i = order[at];
    for (std::uint32_t d = first[i]; d < first[i + 1]; ++d)
      if (donors[d] != i) order.push_back(donors[d]);
  }
  return order;
}

}  // namespace

Drainage drain(const Lattice& lattice) {
  Drainage drainage;
  drainage.receiver.resize(lattice.size());
  for (std::size_t i = 0; i < lattice.size(); ++i) drainage.receiver[i] = steepest_descent(lattice, i);
  drainage.order = upstream_order(drainage.receiver);
  drainage.area_m2.assign(lattice.size(), lattice.step_m * lattice.step_m);
  for (std::size_t at = drainage.order.size(); at-- > 0;) {
    const std::uint32_t i = drainage.order[at];
    if (drainage.receiver[i] != i) drainage.area_m2[drainage.receiver[i]] += drainage.area_m2[i];
  }
  return drainage;
}

}  // namespace citykiln::invent
