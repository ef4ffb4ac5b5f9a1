// Cut lengths and corner radii of all junctions.
// Each junction drafts the cuts it wants from its own arms. Neighbours then divide the links that both want. Radii
// shrink last, to what the final cuts leave. Each step reads only what the step before it decided for all junctions, so
// their order does not matter.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "compiler/geometry/box.h"
#include "compiler/roads/junctions/arm_lines.h"
#include "compiler/roads/junctions/consolidate.h"
#include "compiler/roads/junctions/fillet.h"
#include "compiler/roads/junctions/junction.h"
#include "compiler/roads/junctions/taper.h"

namespace citykiln::roads {
namespace {

double cut_steps(double length_m) { return std::floor(length_m * 4) / 4; }

constexpr double kMinCut_m = 0.5;

// Kerb radii in metres by the minor road's class: the turning radius of its design vehicle.
double radius_m(map::LandCoverClass surface) {
  using map::LandCoverClass;
  constexpr std::pair<LandCoverClass, double> kRadii_m[] = {
      {LandCoverClass::kMotorwayRoad, 15}, {LandCoverClass::kPrimaryRoad, 8},     {LandCoverClass::kSecondaryRoad, 7},
      {LandCoverClass::kTertiaryRoad, 6},  {LandCoverClass::kResidentialRoad, 5}, {LandCoverClass::kServiceRoad, 3},
      {LandCoverClass::kUnpavedRoad, 3},   {LandCoverClass::kPedestrianStreet, 3}};
  const auto row = std::ranges::find(kRadii_m, surface, &std::pair<LandCoverClass, double>::first);
  return row != std::end(kRadii_m) ? row->second : 1.5;
}

// The lengths of two neighbouring arms that one corner takes.
struct Meeting {
  std::uint32_t arm = 0, next = 0;
  double along_arm_m = 0, along_next_m = 0;
};

// A junction in planning. Arms of all its nodes, in the order of arms_of().
struct Draft {
  std::vector<std::uint32_t> nodes;
  Vec2 centre;
  std::vector<Arm> arms;
  std::vector<Link> links;
  std::vector<ArmLine> lines;
  std::vector<ArmPath> paths;
  std::vector<std::uint32_t> next;   // the next arm of the same node, links inside included
  std::vector<std::uint32_t> order;  // counter-clockwise about the centre, without links inside
  std::vector<Meeting> meetings;
  std::vector<Cut> cuts;
};

Draft draft_of(std::span<const Road> roads, std::span<const Node> nodes, const NodeIndex& index,
               std::vector<std::uint32_t> members) {
  Draft draft;
  Box2 box;
  draft.nodes = std::move(members);
  for (const std::uint32_t n : draft.nodes) {
    box.grow(nodes[n].at);
    draft.arms.insert(draft.arms.end(), nodes[n].arms.begin(), nodes[n].arms.end());
  }
  draft.centre = box.centre();
  for (const Arm& arm : draft.arms) {
    draft.links.push_back(index.link_of(arm, 2 * kJunctionRadius_m));
    draft.lines.push_back(arm_line(roads, arm));
    draft.paths.push_back(arm_path(roads, arm));
  }
  draft.cuts.resize(draft.arms.size());
  return draft;
}

// Marks short links between two nodes of one junction as inside it. Long loops stay outside.
void keep_links_inside(std::span<const std::uint32_t> group, Draft& draft) {
  for (std::size_t a = 0; a < draft.arms.size(); ++a) {
    const Link& link = draft.links[a];
    const bool is_inside = draft.nodes.size() > 1 && link.node != kNoNode && group[link.node] == draft.nodes.front();
    if (is_inside && link.length_m <= kJunctionRadius_m) draft.cuts[a].length_m = kWholeLink_m;
  }
}

// The maximum length of an arm within the junction.
double reach_m(const Draft& draft, std::uint32_t arm) {
  if (draft.cuts[arm].length_m == kWholeLink_m) return draft.links[arm].length_m;
  return kJunctionRadius_m - distance(draft.lines[arm].from, draft.centre);
}

// The fillet that a corner wants. Bends of one road get no radius: the ring of a roundabout has one at every node. An
// arc begins at most two radii before its corner, even where the corner is acute.
std::optional<Fillet> wanted_fillet(std::span<const Road> roads, const Draft& draft, std::uint32_t arm,
                                    std::uint32_t next) {
  const Road &road = roads[draft.arms[arm].road], &next_road = roads[draft.arms[next].road];
  const FilletLimits reach{reach_m(draft, arm), reach_m(draft, next)};
  const auto corner = largest_fillet(draft.paths[arm], draft.paths[next], 0, reach);
  if (&road == &next_road) return corner;
  const double wanted = std::min(radius_m(road.surface), radius_m(next_road.surface));
  const double kerb_m = 2 * wanted;
  const FilletLimits limits = !corner ? reach
                                      : FilletLimits{std::min(reach.along_arm_m, corner->arm.along_m + kerb_m),
                                                     std::min(reach.along_next_m, corner->next.along_m + kerb_m)};
  return largest_fillet(draft.paths[arm], draft.paths[next], wanted, limits);
}

void find_order(Draft& draft) {
  draft.next = next_at_node(draft.lines);
  for (const std::uint32_t a : counter_clockwise(draft.lines, draft.centre))
    if (draft.cuts[a].length_m != kWholeLink_m) draft.order.push_back(a);
}

// Corners between neighbouring arms of one node.
void find_corners(std::span<const Road> roads, Draft& draft) {
  for (std::uint32_t arm = 0; arm < draft.arms.size(); ++arm) {
    const std::uint32_t next = draft.next[arm];
    if (arm == next) continue;
    if (const auto fillet = wanted_fillet(roads, draft, arm, next)) {
      draft.meetings.push_back({arm, next, fillet->arm.along_m, fillet->next.along_m});
      draft.cuts[arm].radius_m = fillet->radius_m;
    } else if (const auto corner = corner_between(draft.lines[arm], draft.lines[next])) {
      draft.meetings.push_back({arm, next, corner->along_arm_m, corner->along_next_m});
    }
  }
}

// Overlaps between neighbouring arms of different nodes.
void find_overlaps(Draft& draft) {
  for (std::size_t i = 0; i < draft.order.size(); ++i) {
    const std::uint32_t arm = draft.order[i], next = draft.order[(i + 1) % draft.order.size()];
    if (draft.lines[arm].from == draft.lines[next].from) continue;
    if (const auto corner = corner_between(draft.lines[arm], draft.lines[next]))
      draft.meetings.push_back({arm, next, corner->along_arm_m, corner->along_next_m});
  }
}

// Arms of circular nodes begin outside the disk.
void want_disks(std::span<const Road> roads, std::span<const Node> nodes, Draft& draft) {
  std::size_t arm = 0;
  for (const std::uint32_t n : draft.nodes) {
    const double radius_m = disk_radius_m(roads, nodes[n].arms);
    for (std::size_t i = 0; i < nodes[n].arms.size(); ++i, ++arm)
      if (draft.cuts[arm].length_m != kWholeLink_m) draft.cuts[arm].length_m = radius_m;
  }
}

bool is_taper_draft(Family family, const Draft& draft) {
  const auto is_whole = [](const Cut& cut) { return cut.length_m == kWholeLink_m; };
  const auto is_round = [](const Cut& cut) { return cut.length_m > 0; };
  return draft.nodes.size() == 1 && is_taper(family, draft.lines) && std::ranges::none_of(draft.cuts, is_whole) &&
         std::ranges::none_of(draft.cuts, is_round);
}

// A taper uses at most half a link and leaves the rest to the other end.
void want_taper(Draft& draft) {
  for (const std::uint32_t arm : {0u, 1u}) {
    const double length_m = taper_length_m(draft.paths[arm], draft.paths[1 - arm]);
    draft.cuts[arm].length_m = std::max(kMinCut_m, std::min(length_m, draft.links[arm].length_m / 2));
  }
}

void want(Cut& cut, double length_m) {
  if (cut.length_m != kWholeLink_m) cut.length_m = std::max(cut.length_m, std::min(length_m, kJunctionRadius_m));
}

// Raises each cut to the farther of its arm's two corners.
void want_cuts(Draft& draft) {
  for (const Meeting& meeting : draft.meetings) {
    want(draft.cuts[meeting.arm], meeting.along_arm_m);
    want(draft.cuts[meeting.next], meeting.along_next_m);
  }
  for (const std::uint32_t arm : draft.order) {
    // a minimum, so that every junction is visible
    draft.cuts[arm].length_m = std::max(draft.cuts[arm].length_m, kMinCut_m);
    // multiples of 1/2 m compress better in the manifest than multiples of 1/4 m
    const double cut_m = std::ceil(draft.cuts[arm].length_m * 2) / 2;
    draft.cuts[arm].length_m = std::min(cut_m, std::ceil(reach_m(draft, arm) * 4) / 4);
  }
}

// Divides a link between the junctions at its ends in proportion to what both want, if that is more than its length.
void divide_link(std::span<const Road> roads, Cut& cut, const Arm& arm, const Link& link, const Cut* other,
                 Report& report) {
  if (cut.length_m == kWholeLink_m) return;
  const double wanted_there = other && other->length_m != kWholeLink_m ? other->length_m : 0;
  if (cut.length_m + wanted_there <= link.length_m) return;
  report.add(Code::kRoadInsideJunctions, roads[arm.road].id.osm, link.length_m);
  cut.length_m = cut_steps(link.length_m * cut.length_m / (cut.length_m + wanted_there));
}

// Shrinks radii to what the cuts leave of the arms.
void shrink_radii(Draft& draft) {
  const auto length_m = [&](std::uint32_t arm) {
    return draft.cuts[arm].length_m == kWholeLink_m ? draft.links[arm].length_m : draft.cuts[arm].length_m;
  };
  for (std::uint32_t arm = 0; arm < draft.arms.size(); ++arm) {
    double& radius = draft.cuts[arm].radius_m;
    if (radius == 0) continue;
    const std::uint32_t next = draft.next[arm];
    const auto fillet = largest_fillet(draft.paths[arm], draft.paths[next], radius, {length_m(arm), length_m(next)});
    radius = fillet ? fillet->radius_m : 0;
  }
}

Junction finished(std::span<const Node> nodes, const Draft& draft) {
  Junction junction{nodes[draft.nodes.front()].family, {}, draft.cuts};
  for (const std::uint32_t n : draft.nodes) junction.nodes.push_back(nodes[n].at);
  return junction;
}

std::vector<Draft> drafts_of(std::span<const Road> roads, std::span<const Node> nodes, const NodeIndex& index,
                             std::span<const std::uint32_t> group) {
  std::vector<std::vector<std::uint32_t>> members(nodes.size());
  for (std::uint32_t n = 0; n < nodes.size(); ++n) members[group[n]].push_back(n);
  std::vector<Draft> drafts(nodes.size());
  for (std::uint32_t n = 0; n < nodes.size(); ++n) {
    if (members[n].empty()) continue;
    Draft& draft = drafts[n] = draft_of(roads, nodes, index, std::move(members[n]));
    keep_links_inside(group, draft);
    find_order(draft);
    want_disks(roads, nodes, draft);
    if (is_taper_draft(nodes[n].family, draft)) {
      want_taper(draft);
    } else {
      find_corners(roads, draft);
      find_overlaps(draft);
    }
    want_cuts(draft);
  }
  return drafts;
}

}  // namespace

std::vector<Junction> plan_junctions(std::span<const Road> roads, Report& report) {
  const std::vector<Node> nodes = find_nodes(roads);
  const NodeIndex index(roads, nodes);
  const std::vector<std::uint32_t> group = consolidate(roads, nodes, index, report);
  const std::vector<Draft> wanted = drafts_of(roads, nodes, index, group);

  // the index of each node's first arm within its group
  std::vector<std::uint32_t> first(nodes.size());
  for (const Draft& draft : wanted) {
    std::uint32_t count = 0;
    for (const std::uint32_t n : draft.nodes)
      first[n] = count, count += static_cast<std::uint32_t>(nodes[n].arms.size());
  }
  std::vector<std::pair<Arm, Junction>> junctions;
  for (const Draft& draft : wanted) {
    if (draft.nodes.empty()) continue;
    Draft shared = draft;
    for (std::size_t a = 0; a < shared.arms.size(); ++a) {
      const Link& link = shared.links[a];
      const Cut* other = link.node == kNoNode ? nullptr : &wanted[group[link.node]].cuts[first[link.node] + link.arm];
      divide_link(roads, shared.cuts[a], shared.arms[a], link, other, report);
    }
    shrink_radii(shared);
    junctions.emplace_back(std::ranges::min(shared.arms), finished(nodes, shared));
  }
  // sorted along the roads: neighbours share points, which makes manifests smaller
  std::ranges::sort(junctions, {}, &std::pair<Arm, Junction>::first);
  std::vector<Junction> sorted;
  for (auto& [first_arm, junction] : junctions) sorted.push_back(std::move(junction));
  return sorted;
}

}  // namespace citykiln::roads
