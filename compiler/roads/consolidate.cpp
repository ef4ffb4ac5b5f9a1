#include "compiler/roads/consolidate.h"

#include <algorithm>
#include <limits>

#include "compiler/geometry/box.h"
#include "compiler/roads/arm_lines.h"
#include "compiler/roads/junction.h"

namespace citykiln::roads {
namespace {

constexpr int kRounds = 3;

// Corners sharper than this lie far out without making two junctions one.
constexpr double kBluntSine = 0.5;

// Shorter links are mappers' precision, not roads.
constexpr double kShortLink_m = 2;

// How much of each arm of a node its corners take.
std::vector<double> taken_by_corners(std::span<const Road> roads, const Node& node) {
  std::vector<ArmLine> lines;
  for (const Arm& arm : node.arms) lines.push_back(line_of(roads, arm));
  const std::vector<std::uint32_t> order = counter_clockwise(lines, node.at);
  std::vector<double> taken(lines.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::uint32_t arm = order[i], next = order[(i + 1) % order.size()];
    const auto corner = arm == next ? std::nullopt : corner_between(lines[arm], lines[next]);
    if (!corner || corner->sine < kBluntSine) continue;
    taken[arm] = std::max(taken[arm], corner->along_arm_m);
    taken[next] = std::max(taken[next], corner->along_next_m);
  }
  return taken;
}

// A short link between two nodes.
struct ShortLink {
  double length_m = std::numeric_limits<double>::infinity();
  std::uint32_t from = kNoNode, to = kNoNode;
  ObjectId road;
  // the shortest first; equal ones by their ends, whichever end they are seen from
  bool is_before(const ShortLink& o) const {
    return std::tuple(length_m, std::min(from, to), std::max(from, to)) <
           std::tuple(o.length_m, std::min(o.from, o.to), std::max(o.from, o.to));
  }
};

std::vector<ShortLink> short_links(std::span<const Road> roads, std::span<const Node> nodes, const NodeIndex& index) {
  std::vector<std::vector<double>> taken;
  for (const Node& node : nodes) taken.push_back(taken_by_corners(roads, node));
  std::vector<ShortLink> links;
  for (std::uint32_t n = 0; n < nodes.size(); ++n)
    for (std::size_t a = 0; a < nodes[n].arms.size(); ++a) {
      const Link link = index.link_of(nodes[n].arms[a], kReach_m);
      if (link.node == kNoNode || link.node == n || nodes[link.node].family != nodes[n].family) continue;
      if (link.length_m <= std::max(kShortLink_m, taken[n][a] + taken[link.node][link.arm]))
        links.push_back({link.length_m, n, link.node, roads[nodes[n].arms[a].road].id});
    }
  return links;
}

bool fits(const Box2& box) { return std::max(box.width(), box.height()) <= kReach_m / 2; }

// One round: groups that are each other's nearest become one.
void merge_nearest(std::span<const ShortLink> links, std::vector<std::uint32_t>& group, std::vector<Box2>& boxes,
                   Report& report) {
  std::vector<ShortLink> nearest(group.size());
  for (ShortLink link : links) {
    link.from = group[link.from], link.to = group[link.to];
    if (link.from == link.to) continue;
    Box2 both = boxes[link.from];
    both.grow(boxes[link.to].min), both.grow(boxes[link.to].max);
    if (fits(both) && link.is_before(nearest[link.from])) nearest[link.from] = link;
  }
  std::vector<std::uint32_t> into(group.size());
  for (std::uint32_t g = 0; g < into.size(); ++g) into[g] = g;
  for (std::uint32_t g = 0; g < nearest.size(); ++g) {
    const std::uint32_t other = nearest[g].to;
    if (other == kNoNode || other < g || nearest[other].to != g) continue;
    into[other] = g;
    boxes[g].grow(boxes[other].min), boxes[g].grow(boxes[other].max);
    report.add(Code::kJunctionsMerged, nearest[g].road.osm, nearest[g].length_m);
  }
  for (std::uint32_t& g : group) g = into[g];
}

}  // namespace

std::vector<std::uint32_t> consolidate(std::span<const Road> roads, std::span<const Node> nodes, const NodeIndex& index,
                                       Report& report) {
  std::vector<std::uint32_t> group(nodes.size());
  std::vector<Box2> boxes(nodes.size());
  for (std::uint32_t n = 0; n < nodes.size(); ++n) {
    group[n] = n;
    boxes[n].grow(nodes[n].at);
  }
  const std::vector<ShortLink> links = short_links(roads, nodes, index);
  for (int round = 0; round < kRounds; ++round) merge_nearest(links, group, boxes, report);
  return group;
}

}  // namespace citykiln::roads
