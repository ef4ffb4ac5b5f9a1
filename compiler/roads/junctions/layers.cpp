#include "compiler/roads/junctions/layers.h"

#include <algorithm>
#include <compare>
#include <map>
#include <utility>

#include "compiler/contract/disjoint_sets.h"
#include "compiler/roads/roads_on_ground.h"

namespace citykiln::roads {
namespace {

using Tracks = std::vector<const map::Track*>;

Tracks tracks_off_ground(const map::FeatureView& features) {
  Tracks tracks;
  for (const map::Track& track : features.tracks)
    if (track.passage != map::Passage::kGround) tracks.push_back(&track);
  return tracks;
}

// Without layer=*, a bridge is at layer 1 and a tunnel at layer -1.
int own_layer(const map::Track& track) {
  if (track.layer != 0) return track.layer;
  return track.passage == map::Passage::kBridge ? 1 : -1;
}

// A node of a track.
struct TrackNode {
  map::Passage passage;
  std::int64_t node_id;
  std::uint32_t track;
  auto operator<=>(const TrackNode&) const = default;
  bool meets(const TrackNode& other) const { return passage == other.passage && node_id == other.node_id; }
};

std::vector<TrackNode> track_nodes_of(const Tracks& tracks) {
  std::vector<TrackNode> track_nodes;
  for (std::uint32_t t = 0; t < tracks.size(); ++t)
    for (const std::int64_t node_id : tracks[t]->node_ids) track_nodes.push_back({tracks[t]->passage, node_id, t});
  std::ranges::sort(track_nodes);
  return track_nodes;
}

// The layer of each track: the minimum over all tracks that shared nodes connect it to.
std::vector<int> layers_of(const Tracks& tracks) {
  DisjointSets sets(tracks.size());
  const std::vector<TrackNode> track_nodes = track_nodes_of(tracks);
  for (std::size_t i = 1; i < track_nodes.size(); ++i)
    if (track_nodes[i].meets(track_nodes[i - 1])) sets.join(track_nodes[i].track, track_nodes[i - 1].track);

  std::vector<int> lowest, layers;
  for (const map::Track* track : tracks) lowest.push_back(own_layer(*track));
  // a set's first member has the lowest index
  for (std::uint32_t t = 0; t < tracks.size(); ++t) {
    int& of_set = lowest[sets.find(t)];
    of_set = std::min(of_set, lowest[t]);
  }
  for (std::uint32_t t = 0; t < tracks.size(); ++t) layers.push_back(lowest[sets.find(t)]);
  return layers;
}

void count(const RoadLayer& layer, Account& account) {
  for (const Junction& junction : layer.junctions) {
    account.in += junction.nodes.size();
    account.merged += junction.nodes.size() - 1;
    ++account.out;
  }
}

}  // namespace

std::vector<RoadLayer> plan_layers(const map::FeatureView& features, Report& report) {
  const Tracks tracks = tracks_off_ground(features);
  const std::vector<int> layers = layers_of(tracks);
  std::map<std::pair<int, map::Passage>, std::vector<Road>> roads;
  for (std::size_t t = 0; t < tracks.size(); ++t) roads[{layers[t], tracks[t]->passage}].push_back(road_of(*tracks[t]));

  std::vector<RoadLayer> planned;
  Account account;
  for (auto& [name, of_layer] : roads) {
    std::vector<Junction> junctions = plan_junctions(of_layer, report);
    planned.push_back(
        {.layer = name.first, .passage = name.second, .roads = std::move(of_layer), .junctions = std::move(junctions)});
    count(planned.back(), account);
  }
  report.account("roads", "junction_off_ground") = account;
  return planned;
}

}  // namespace citykiln::roads
