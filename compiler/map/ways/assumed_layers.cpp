#include "compiler/map/ways/assumed_layers.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <tuple>

#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/segment.h"

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

// ---- bridges that cross ---------------------------------------------------------------------------------------------

// The bridges of the map, from the one that is lowest where they cross to the one that is above all.
std::vector<std::uint32_t> bridges_upwards(const std::vector<Track>& tracks) {
  std::vector<std::uint32_t> bridges;
  for (std::uint32_t t = 0; t < tracks.size(); ++t)
    if (tracks[t].passage == Passage::kBridge) bridges.push_back(t);
  std::ranges::sort(bridges, {}, [&](std::uint32_t t) {
    const LandCoverValues& values = values_of(tracks[t].surface);
    return std::tuple(values.group == LandCoverGroup::kPath, values.priority, length_m(tracks[t].axis), tracks[t].id);
  });
  return bridges;
}

bool share_node(const Track& a, const Track& b) {
  return std::ranges::any_of(a.node_ids, [&](std::int64_t id) { return std::ranges::count(b.node_ids, id) > 0; });
}

bool cross_each_other(const Track& a, const Track& b) {
  for (std::size_t i = 0; i + 1 < a.axis.size(); ++i)
    for (std::size_t j = 0; j + 1 < b.axis.size(); ++j)
      if (crossing_shares(a.axis[i], a.axis[i + 1], b.axis[j], b.axis[j + 1])) return !share_node(a, b);
  return false;
}

int layer_of_bridge(const Track& track) { return track.layer == 0 ? 1 : track.layer; }

}  // namespace

std::vector<Track> with_ordered_bridges(std::vector<Track> tracks, Report& report) {
  constexpr double kBucket_m = 64;
  constexpr int kHighest = 10;
  const std::vector<std::uint32_t> bridges = bridges_upwards(tracks);
  std::vector<Box2> boxes;
  std::vector<int> mapped, layers;
  for (const std::uint32_t t : bridges) {
    boxes.push_back(box_of(tracks[t].axis));
    mapped.push_back(layer_of_bridge(tracks[t]));
  }
  layers = mapped;
  const BoxGrid grid = grid_of(boxes, kBucket_m);
  for (std::uint32_t above = 0; above < bridges.size(); ++above) {
    Track& track = tracks[bridges[above]];
    for (const std::uint32_t below : boxes_about(grid, boxes[above]))
      if (below < above && mapped[below] == mapped[above] && layers[below] >= layers[above] &&
          boxes[below].touches(boxes[above]) && cross_each_other(track, tracks[bridges[below]]))
        layers[above] = std::min(kHighest, layers[below] + 1);
    if (layers[above] == mapped[above]) continue;
    track.layer = static_cast<std::int8_t>(layers[above]);
    report.add(Code::kBridgeOrderAssumed, track.id.osm, layers[above]);
  }
  return tracks;
}

std::vector<Track> with_assumed_layers(std::vector<Track> tracks) {
  const std::vector<LayeredNode> nodes = layered_nodes(tracks);
  for (Track& track : tracks)
    if (lacks_layer(track)) track.layer = continued_layer(track, nodes).value_or(std::int8_t{0});
  return tracks;
}

}  // namespace citykiln::map
