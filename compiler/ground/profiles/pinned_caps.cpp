#include "compiler/ground/profiles/pinned_caps.h"

namespace citykiln::ground {

std::vector<double> caps_near_pinned(const ProfileGraph& graph, GraphWalk& walk, std::span<const double> z_m) {
  std::vector<double> cap_m(z_m.size(), std::numeric_limits<double>::infinity());
  for (std::uint32_t n = 0; n < z_m.size(); ++n) {
    // what meets nothing may leave the ground
    if (!graph.nodes[n].is_pinned || graph.nodes[n].is_free_end) continue;
    const GraphWalk::Start start{0, n};
    walk.from(
        std::span(&start, 1), kPinRadius_m, [&](const Leg& leg) { return limit_of(graph, leg) * leg.length_m; },
        [&](std::uint32_t node, double up_m) {
          cap_m[node] = std::min(cap_m[node], z_m[n] + up_m);
          return true;
        });
  }
  return cap_m;
}

}  // namespace citykiln::ground
