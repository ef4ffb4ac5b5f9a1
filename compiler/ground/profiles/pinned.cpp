#include "compiler/ground/profiles/pinned.h"

namespace citykiln::ground {

std::vector<double> caps_of_pinned(const ProfileGraph& graph, GraphWalk& walk, std::span<const double> z_m) {
  std::vector<double> cap_m(z_m.size(), std::numeric_limits<double>::infinity());
  for (std::uint32_t n = 0; n < z_m.size(); ++n) {
    // what meets nothing may leave the ground
    if (!graph.nodes[n].is_pinned || graph.nodes[n].is_loose) continue;
    const GraphWalk::Start start{0, n};
    walk.from(
        std::span(&start, 1), kPinReach_m, [&](const Leg& leg) { return limit_of(graph, leg) * leg.length_m; },
        [&](std::uint32_t node, double up_m) {
          cap_m[node] = std::min(cap_m[node], z_m[n] + up_m);
          return true;
        });
  }
  return cap_m;
}

}  // namespace citykiln::ground
