#include "compiler/roads/junctions/junction_links.h"

#include <algorithm>
#include <cassert>

namespace citykiln::roads {

NodeIndex::NodeIndex(std::span<const Road> roads, std::span<const Node> nodes) : roads_(roads), nodes_(nodes) {
  std::uint32_t count = 0;
  for (const Road& road : roads) {
    first_.push_back(count);
    count += static_cast<std::uint32_t>(road.axis.size());
  }
  node_at_.assign(count, kNoNode);
  for (std::uint32_t node = 0; node < nodes.size(); ++node)
    for (const Arm& arm : nodes[node].arms) node_at_[first_[arm.road] + arm.vertex] = node;
}

Link NodeIndex::link_of(const Arm& arm, double max_m) const {
  assert(arm.road < roads_.size() && arm.vertex < roads_[arm.road].axis.size());
  assert(max_m >= 0);
  const Polyline& axis = roads_[arm.road].axis;
  Link link;
  const auto last = static_cast<std::int64_t>(axis.size()) - 1;
  for (std::int64_t v = arm.vertex; v + arm.step >= 0 && v + arm.step <= last && link.length_m <= max_m;) {
    const auto here = static_cast<std::size_t>(v), next = static_cast<std::size_t>(v + arm.step);
    link.length_m += distance(axis[here], axis[next]);
    link.node = node_at_[first_[arm.road] + next];
    v += arm.step;
    if (link.node == kNoNode) continue;
    const std::vector<Arm>& arms = nodes_[link.node].arms;
    const Arm back{arm.road, static_cast<std::uint32_t>(v), -arm.step};
    link.arm = static_cast<std::uint32_t>(std::ranges::lower_bound(arms, back) - arms.begin());
    return link;
  }
  return link;
}

}  // namespace citykiln::roads
