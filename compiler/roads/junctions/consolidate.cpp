#include "compiler/roads/junctions/consolidate.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "compiler/geometry/box.h"
#include "compiler/roads/junctions/arm_lines.h"
#include "compiler/roads/junctions/junction.h"

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

namespace {

constexpr int kRounds = 3;

// Acute corners lie far out, which does not make two junctions one: sine of the smallest angle that counts.
constexpr double kBluntSine = 0.5;

// Links shorter than this come from imprecise mapping.
constexpr double kShortLink_m = 2;

// The length of a car: room to stop between two junctions.
constexpr double kCar_m = 5;

// Maximum extent of merged nodes that are not street junctions.
constexpr double kNearReach_m = kJunctionRadius_m / 2;

// Widest median, in widths of the wider carriageway, that keeps the crossing of a dual carriageway one junction.
constexpr double kWidestMedian = 1.5;

// The length of each arm of a node that its corners take.
std::vector<double> taken_by_corners(std::span<const Road> roads, const Node& node) {
  const std::vector<ArmLine> lines = arm_lines(roads, node.arms);
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

// A link that may merge the groups at its ends.
struct ShortLink {
  double length_m = std::numeric_limits<double>::infinity();
  std::uint32_t from = kNoNode, to = kNoNode;
  ObjectId road;
  double max_extent_m = 0;  // maximum extent of the merged group
  // shortest first, ties by the unordered pair of ends
  bool is_before(const ShortLink& o) const {
    return std::tuple(length_m, std::min(from, to), std::max(from, to)) <
           std::tuple(o.length_m, std::min(o.from, o.to), std::max(o.from, o.to));
  }
};

// At least three streets meet, and the node is not circular.
bool is_street_junction(std::span<const Road> roads, const Node& node) {
  const auto streets =
      std::ranges::count_if(node.arms, [&](const Arm& arm) { return is_through_street(roads[arm.road]); });
  return streets >= 3 && disk_radius_m(roads, node.arms) == 0;
}

// 1 where all traffic leaves along the arm, -1 where all arrives, else 0.
int oneway(std::span<const Road> roads, const Arm& arm) {
  bool has_along = false, has_against = false;
  for (const map::Lane& lane : roads[arm.road].section.lanes) {
    if (lane.kind != map::LaneKind::kDriving) continue;
    has_along |= lane.way != map::LaneDirection::kBackward;
    has_against |= lane.way != map::LaneDirection::kForward;
  }
  return has_along == has_against ? 0 : has_along ? arm.step : -arm.step;
}

// A one-way carriageway that begins or ends at a node.
struct Carriageway {
  Vec2 along;  // direction of traffic
  double width_m = 0;
};

std::vector<Carriageway> carriageways_across(std::span<const Road> roads, const Node& node, const Arm& link) {
  constexpr double kAcross = 0.5;
  const Vec2 along_link = arm_line(roads, link).along;
  std::vector<Carriageway> across;
  for (const Arm& arm : node.arms) {
    const int way = oneway(roads, arm);
    const Vec2 along = arm_line(roads, arm).along;
    if (way != 0 && std::abs(cross(along, along_link)) > kAcross)
      across.push_back({along * way, width_m(roads[arm.road])});
  }
  return across;
}

// True where opposite carriageways at both ends make the link the crossing of a median.
bool joins_dual_carriageway(std::span<const Carriageway> here, std::span<const Carriageway> there, double between_m) {
  constexpr double kOpposite = -0.8;
  for (const Carriageway& a : here)
    for (const Carriageway& b : there)
      if (dot(a.along, b.along) < kOpposite && between_m <= kWidestMedian * std::max(a.width_m, b.width_m)) return true;
  return false;
}

// A link as seen from one end, not yet known to merge anything.
struct Candidate {
  ShortLink link;
  Arm there, back;
  double between_m = 0;  // length that the corners at both ends leave
};

// True where two links from one node lead to the same other node, around an island.
bool goes_round_island(std::span<const Candidate> from_here, const ShortLink& link) {
  return std::ranges::count_if(from_here, [&](const Candidate& c) { return c.link.to == link.to; }) > 1;
}

bool joins_streets(std::span<const Road> roads, std::span<const Node> nodes, std::span<const Candidate> from_here,
                   const Candidate& c) {
  const Road& road = roads[c.there.road];
  if (!is_through_street(road) || road.is_roundabout) return false;
  if (!is_street_junction(roads, nodes[c.link.from]) || !is_street_junction(roads, nodes[c.link.to])) return false;
  if (c.between_m < kCar_m || goes_round_island(from_here, c.link)) return true;
  return joins_dual_carriageway(carriageways_across(roads, nodes[c.link.from], c.there),
                                carriageways_across(roads, nodes[c.link.to], c.back), c.between_m);
}

std::vector<ShortLink> short_links(std::span<const Road> roads, std::span<const Node> nodes, const NodeIndex& index) {
  std::vector<std::vector<double>> taken;
  for (const Node& node : nodes) taken.push_back(taken_by_corners(roads, node));
  std::vector<ShortLink> links;
  std::vector<Candidate> from_here;
  for (std::uint32_t n = 0; n < nodes.size(); ++n) {
    from_here.clear();
    for (std::size_t a = 0; a < nodes[n].arms.size(); ++a) {
      const Arm& arm = nodes[n].arms[a];
      const Link link = index.link_of(arm, kJunctionRadius_m);
      if (link.node == kNoNode || link.node == n || nodes[link.node].family != nodes[n].family) continue;
      if (link.length_m > kJunctionRadius_m) continue;
      from_here.push_back({{link.length_m, n, link.node, roads[arm.road].id, kNearReach_m},
                           arm,
                           nodes[link.node].arms[link.arm],
                           link.length_m - taken[n][a] - taken[link.node][link.arm]});
    }
    for (Candidate c : from_here) {
      const bool is_nothing = c.link.length_m <= kShortLink_m || c.between_m <= 0;
      if (joins_streets(roads, nodes, from_here, c)) c.link.max_extent_m = kJunctionRadius_m;
      if (is_nothing || c.link.max_extent_m == kJunctionRadius_m) links.push_back(c.link);
    }
  }
  return links;
}

bool fits(const Box2& box, const ShortLink& link) { return std::max(box.width(), box.height()) <= link.max_extent_m; }

// One round: merges the groups that are each other's nearest.
void merge_nearest(std::span<const ShortLink> links, std::vector<std::uint32_t>& group, std::vector<Box2>& boxes,
                   Report& report) {
  std::vector<ShortLink> nearest(group.size());
  for (ShortLink link : links) {
    link.from = group[link.from], link.to = group[link.to];
    if (link.from == link.to) continue;
    Box2 both = boxes[link.from];
    both.grow(boxes[link.to].min), both.grow(boxes[link.to].max);
    if (fits(both, link) && link.is_before(nearest[link.from])) nearest[link.from] = link;
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
