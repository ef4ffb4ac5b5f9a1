#include "compiler/map/assumed_layers.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <tuple>

namespace citykiln::map {
namespace {

// A map node of a bridge or tunnel with a layer.
struct LayeredNode {
  std::int64_t node_id = 0;
  Passage passage{};
  std::int8_t layer = 0;
};

bool precedes(const LayeredNode& a, const LayeredNode& b) {
  return std::tuple(a.node_id, a.passage) < std::tuple(b.node_id, b.passage);
}

std::vector<LayeredNode> layered_nodes(const std::vector<Track>& tracks) {
  std::vector<LayeredNode> nodes;
  for (const Track& track : tracks)
    if (track.passage != Passage::kGround && track.layer != 0)
      for (const std::int64_t id : track.node_ids) nodes.push_back({id, track.passage, track.layer});
  std::ranges::sort(nodes, precedes);
  return nodes;
}

bool lacks_layer(const Track& track) {
  if (track.passage == Passage::kGround || track.layer != 0) return false;
  return track.passage == Passage::kBridge || values_of(track.surface).group != LandCoverGroup::kPath;
}

// The layer of all bridges or tunnels at the track's ends; none if they have no layer or different ones.
std::optional<std::int8_t> continued_layer(const Track& track, const std::vector<LayeredNode>& nodes) {
  std::optional<std::int8_t> layer;
  for (const std::int64_t end : {track.node_ids.front(), track.node_ids.back()}) {
    const LayeredNode wanted{end, track.passage};
    const auto [first, last] = std::equal_range(nodes.begin(), nodes.end(), wanted, precedes);
    for (auto node = first; node != last; ++node) {
      if (layer && *layer != node->layer) return std::nullopt;
      layer = node->layer;
    }
  }
  return layer;
}

}  // namespace

std::vector<Track> with_assumed_layers(std::vector<Track> tracks) {
  const std::vector<LayeredNode> nodes = layered_nodes(tracks);
  for (Track& track : tracks)
    if (lacks_layer(track)) track.layer = continued_layer(track, nodes).value_or(std::int8_t{0});
  return tracks;
}

}  // namespace citykiln::map
