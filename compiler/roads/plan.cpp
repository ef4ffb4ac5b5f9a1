#include "compiler/roads/plan.h"

#include <algorithm>
#include <span>

namespace citykiln::roads {
namespace {

// The node ids that at least two track ends or one end and a track's middle share, sorted. Where a way passes through
// its own node twice that counts as well.
std::vector<std::int64_t> shared_nodes(std::span<const map::Track> tracks) {
  std::vector<std::int64_t> nodes;
  for (const map::Track& track : tracks) nodes.insert(nodes.end(), track.node_ids.begin(), track.node_ids.end());
  std::sort(nodes.begin(), nodes.end());
  std::vector<std::int64_t> shared;
  for (std::size_t i = 1; i < nodes.size(); ++i)
    if (nodes[i] == nodes[i - 1] && (shared.empty() || shared.back() != nodes[i])) shared.push_back(nodes[i]);
  return shared;
}

}  // namespace

std::vector<Road> plan(const map::Features& features, Report& report) {
  std::vector<Road> roads;
  Account account;
  const std::vector<std::int64_t> shared = shared_nodes(features.tracks);
  const auto meets = [&](std::int64_t node) { return std::binary_search(shared.begin(), shared.end(), node); };
  for (const map::Track& track : features.tracks) {
    ++account.in;
    // bridges and tunnels go into structures/
    if (track.passage != map::Passage::kGround) {
      ++account.merged;
      continue;
    }
    ++account.out;
    roads.push_back({track.id, track.axis, track.surface, track.width_m, meets(track.node_ids.front()),
                     meets(track.node_ids.back()), track.pavement_left_m, track.pavement_right_m});
  }
  report.account("roads", "track") = account;
  return roads;
}

}  // namespace citykiln::roads
