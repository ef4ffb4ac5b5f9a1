#include "compiler/structures/span_ends.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "compiler/roads/junctions/junction.h"

namespace citykiln::structures {
namespace {

using map::Track;

// A track that leaves a node towards a neighbouring vertex.
struct Leaving {
  std::int64_t node = 0;
  std::uint32_t track = 0;
  std::uint32_t vertex = 0;
  std::int32_t step = 1;
  auto operator<=>(const Leaving&) const = default;
};

std::vector<Leaving> all_leaving(const map::FeatureView& features) {
  std::vector<Leaving> leaving;
  for (std::uint32_t t = 0; t < features.tracks.size(); ++t) {
    const Track& track = features.tracks[t];
    for (std::uint32_t v = 0; v < track.node_ids.size(); ++v) {
      if (v > 0) leaving.push_back({track.node_ids[v], t, v, -1});
      if (v + 1 < track.node_ids.size()) leaving.push_back({track.node_ids[v], t, v, 1});
    }
  }
  std::ranges::sort(leaving);
  return leaving;
}

double half_width_m(const Track& track) { return map::total_width_m(track.section) / 2; }

struct EndFinder {
  const map::FeatureView& features;
  std::vector<Leaving> leaving = all_leaving(features);

  const Track& track_of(const Leaving& l) const { return features.tracks[l.track]; }
  Vec2 beyond(const Leaving& l) const { return track_of(l).axis[l.vertex + l.step]; }
  Vec2 direction(const Leaving& l) const { return unit(beyond(l) - track_of(l).axis[l.vertex]); }

  std::span<const Leaving> at_node(std::int64_t node) const {
    return {std::ranges::lower_bound(leaving, node, {}, &Leaving::node),
            std::ranges::upper_bound(leaving, node, {}, &Leaving::node)};
  }
  // The other tracks of the end's family at its node: those on the ground, or those of its passage.
  std::vector<Leaving> others(const Leaving& end, bool on_ground) const {
    std::vector<Leaving> chosen;
    const map::Passage passage = on_ground ? map::Passage::kGround : track_of(end).passage;
    for (const Leaving& l : at_node(end.node))
      if (l != end && track_of(l).passage == passage &&
          roads::family_of(track_of(l).surface) == roads::family_of(track_of(end).surface))
        chosen.push_back(l);
    std::ranges::sort(chosen, {}, [&](const Leaving& l) { return std::tuple(track_of(l).id, l.vertex, l.step); });
    return chosen;
  }
  bool touches_ground(const Leaving& end) const {
    return std::ranges::any_of(at_node(end.node),
                               [&](const Leaving& l) { return track_of(l).passage == map::Passage::kGround; });
  }
  bool continues(const Leaving& end, const Leaving& other) const { return dot(direction(end), direction(other)) < 0; }

  // The length of a span that lies on the roads that pass its end.
  double cut_m(const Leaving& end, std::span<const Leaving> passing) const {
    constexpr double kMaxCut_m = 24, kStep_m = 0.25;
    double cut_m = 0;
    for (const Leaving& l : passing) {
      const double sin = std::abs(cross(direction(end), direction(l)));
      if (sin > 0.25) cut_m = std::max(cut_m, half_width_m(track_of(l)) / sin);
    }
    return std::min(kMaxCut_m, std::ceil(cut_m / kStep_m) * kStep_m);
  }

  SpanEnd end_of(const Leaving& end) const {
    const std::vector<Leaving> spans = others(end, false);
    if (spans.size() == 1 && continues(end, spans[0])) return {EndKind::kJoint, beyond(spans[0]), 0};
    if (!spans.empty()) return {};
    const std::vector<Leaving> roads = others(end, true);
    if (roads.size() == 1 && continues(end, roads[0])) return {EndKind::kGround, beyond(roads[0]), 0};
    if (!roads.empty()) return {EndKind::kBesideRoad, {}, cut_m(end, roads)};
    return {touches_ground(end) ? EndKind::kBesideRoad : EndKind::kFree, {}, 0};
  }
};

}  // namespace

std::vector<SpanEnds> find_ends(const map::FeatureView& features) {
  const EndFinder finder{features};
  std::vector<SpanEnds> ends;
  for (std::uint32_t t = 0; t < features.tracks.size(); ++t) {
    const Track& track = features.tracks[t];
    if (track.passage == map::Passage::kGround) continue;
    if (track.node_ids.size() < 2) {
      ends.emplace_back();
      continue;
    }
    const auto last = static_cast<std::uint32_t>(track.node_ids.size() - 1);
    ends.push_back(
        {finder.end_of({track.node_ids.front(), t, 0, 1}), finder.end_of({track.node_ids.back(), t, last, -1})});
  }
  return ends;
}

}  // namespace citykiln::structures
