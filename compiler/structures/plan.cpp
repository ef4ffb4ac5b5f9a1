#include "compiler/structures/plan.h"

#include <algorithm>

#include "compiler/geometry/snap.h"
#include "compiler/structures/deck_graph.h"
#include "compiler/structures/deck_heights.h"

namespace citykiln::structures {
namespace {

// A station that the straight line misses by less than this is not worth its vertices.
constexpr double kStraight_m = 0.01;

std::vector<const map::Track*> tracks_in(const map::Features& features, map::Passage passage) {
  std::vector<const map::Track*> tracks;
  for (const map::Track& track : features.tracks)
    if (track.passage == passage) tracks.push_back(&track);
  std::sort(tracks.begin(), tracks.end(), [](const auto* a, const auto* b) { return a->id < b->id; });
  return tracks;
}

// How far the axis between two of its points passes from the chord, in plan and in height, and where it is farthest.
std::pair<double, std::size_t> bulge(const std::vector<Vec3>& axis, std::size_t first, std::size_t last) {
  std::pair<double, std::size_t> worst = {0, first};
  const Vec3 chord = axis[last] - axis[first];
  const double length2 = std::max(dot(in_plan(chord), in_plan(chord)), kQuantum_m * kQuantum_m);
  for (std::size_t i = first + 1; i < last; ++i) {
    const Vec3 off = axis[i] - axis[first];
    const double share = std::clamp(dot(in_plan(off), in_plan(chord)) / length2, 0.0, 1.0);
    worst = std::max(worst, {length(off - chord * share), i},
                     [](const auto& a, const auto& b) { return a.first < b.first; });
  }
  return worst;
}

// Douglas and Peucker (1973).
void keep_bends(const std::vector<Vec3>& axis, std::size_t first, std::size_t last, std::vector<Vec3>& kept) {
  const auto [miss_m, at] = bulge(axis, first, last);
  if (miss_m > kStraight_m) {
    keep_bends(axis, first, at, kept);
    keep_bends(axis, at, last, kept);
  } else {
    kept.push_back(axis[last]);
  }
}

Span bridge_of(const map::Track& track, const DeckGraph& graph, const std::vector<std::uint32_t>& stations,
               const std::vector<double>& heights_m) {
  std::vector<Vec3> axis;
  for (const std::uint32_t s : stations) axis.push_back(at_height(graph.stations[s].at, heights_m[s]));
  Span span{track.id, {axis.front()}, track.surface, map::carriageway_width_m(track.section)};
  keep_bends(axis, 0, axis.size() - 1, span.axis);
  return span;
}

Span tunnel_of(const map::Track& track, const map::Heightfield& heights) {
  Span span{track.id, {}, track.surface, map::carriageway_width_m(track.section)};
  const double from_m = height_m_at(heights, track.axis.front()), to_m = height_m_at(heights, track.axis.back());
  const double whole_m = length_m(track.axis);
  double walked_m = 0;
  for (std::size_t i = 0; i < track.axis.size(); ++i) {
    if (i > 0) walked_m += distance(track.axis[i - 1], track.axis[i]);
    const double share = whole_m > 0 ? walked_m / whole_m : 0;
    span.axis.push_back(snapped(at_height(track.axis[i], from_m + (to_m - from_m) * share)));
  }
  return span;
}

void count(Report& report, const char* kind, std::size_t spans) {
  Account& account = report.account("structures", kind);
  account.in += spans;
  account.out += spans;
}

}  // namespace

Structures plan(const map::Features& features, const map::Heightfield& heights, Report& report) {
  Structures structures;
  const auto bridges = tracks_in(features, map::Passage::kBridge);
  const DeckGraph graph = graph_of(bridges, features, heights, report);
  const std::vector<double> heights_m = deck_heights(graph);
  for (std::size_t i = 0; i < bridges.size(); ++i)
    structures.bridges.push_back(bridge_of(*bridges[i], graph, graph.bridges[i], heights_m));
  for (const map::Track* tunnel : tracks_in(features, map::Passage::kTunnel)) {
    report.add(Code::kTunnelNotMeshed, tunnel->id.osm);
    structures.tunnels.push_back(tunnel_of(*tunnel, heights));
  }
  count(report, "bridge", structures.bridges.size());
  count(report, "tunnel", structures.tunnels.size());
  return structures;
}

}  // namespace citykiln::structures
