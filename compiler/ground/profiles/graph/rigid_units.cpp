#include "compiler/ground/profiles/graph/rigid_units.h"

namespace citykiln::ground {

RigidUnits::RigidUnits(const ProfileGraph& graph) : of(graph.nodes.size()) {
  std::vector<std::uint32_t> of_junction;
  std::uint32_t count = 0;
  for (std::uint32_t n = 0; n < of.size(); ++n) {
    const std::uint32_t j = graph.nodes[n].junction;
    if (j != kNone && j >= of_junction.size()) of_junction.resize(j + 1, kNone);
    of[n] = j == kNone || of_junction[j] == kNone ? count++ : of_junction[j];
    if (j != kNone) of_junction[j] = of[n];
  }
  first.assign(count + 1, 0);
  for (const std::uint32_t unit : of) ++first[unit + 1];
  for (std::uint32_t u = 0; u < count; ++u) first[u + 1] += first[u];
  nodes.resize(of.size());
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  for (std::uint32_t n = 0; n < of.size(); ++n) nodes[next[of[n]]++] = n;
}

}  // namespace citykiln::ground
