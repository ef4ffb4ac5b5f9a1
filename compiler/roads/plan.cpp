#include "compiler/roads/plan.h"

#include <algorithm>
#include <span>
#include <utility>

#include "compiler/roads/network.h"

namespace citykiln::roads {
namespace {

// How many arms of a family leave each node.
using Arms = std::vector<std::pair<std::int64_t, Family>>;

Arms arms_at_nodes(std::span<const map::Track> tracks) {
  Arms arms;
  for (const map::Track& track : tracks)
    for (std::size_t i = 0; i < track.node_ids.size(); ++i)
      for (const bool leaves : {i > 0, i + 1 < track.node_ids.size()})
        if (leaves) arms.emplace_back(track.node_ids[i], family_of(track.surface));
  std::sort(arms.begin(), arms.end());
  return arms;
}

// Where a road goes on into another, a round end fills the wedge between them; where more meet there is a junction.
// Rails have none.
bool rounds_at(const Arms& arms, std::int64_t node, Family family) {
  const auto [first, last] = std::equal_range(arms.begin(), arms.end(), std::pair(node, family));
  return family == Family::kOther ? last - first > 1 : last - first == 2;
}

}  // namespace

std::vector<Road> plan(const map::Features& features, Report& report) {
  std::vector<Road> roads;
  Account account;
  const Arms arms = arms_at_nodes(features.tracks);
  for (const map::Track& track : features.tracks) {
    ++account.in;
    // bridges and tunnels go into structures/
    if (track.passage != map::Passage::kGround) {
      ++account.merged;
      continue;
    }
    ++account.out;
    const Family family = family_of(track.surface);
    roads.push_back({track.id, track.axis, track.surface, track.width_m,
                     rounds_at(arms, track.node_ids.front(), family), rounds_at(arms, track.node_ids.back(), family),
                     track.pavement_left_m, track.pavement_right_m});
  }
  report.account("roads", "track") = account;
  return roads;
}

}  // namespace citykiln::roads
