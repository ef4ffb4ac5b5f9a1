#include "compiler/map/lanes/transitions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "compiler/geometry/snap.h"

namespace citykiln::map {
namespace {

// One of both ends of a track.
struct TrackEnd {
  std::size_t track = 0;
  bool is_last = false;
};

using EndsOfNode = std::map<std::int64_t, std::vector<TrackEnd>>;

std::int64_t node_of(const Track& track, bool is_last) {
  return is_last ? track.node_ids.back() : track.node_ids.front();
}

// The direction in which a track leaves its end.
Vec2 direction_from(const Track& track, bool is_last) {
  const std::size_t n = track.axis.size();
  return is_last ? unit(track.axis[n - 2] - track.axis[n - 1]) : unit(track.axis[1] - track.axis[0]);
}

double whole_length_m(const Track& track) {
  double sum_m = 0;
  for (std::size_t i = 0; i + 1 < track.axis.size(); ++i) sum_m += snapped(distance(track.axis[i], track.axis[i + 1]));
  return sum_m;
}

bool can_go_over(const Track& track) {
  return track.is_transition && track.axis.front() != track.axis.back() && whole_length_m(track) < kLongestTransition_m;
}

// The ends of all tracks at the nodes at which transitions end.
EndsOfNode ends_at_transitions(const std::vector<Track>& tracks) {
  EndsOfNode ends;
  for (const Track& track : tracks)
    if (can_go_over(track)) ends[node_of(track, false)], ends[node_of(track, true)];
  for (std::size_t t = 0; t < tracks.size(); ++t)
    for (const bool is_last : {false, true})
      if (const auto found = ends.find(node_of(tracks[t], is_last)); found != ends.end())
        found->second.push_back({t, is_last});
  return ends;
}

// The distances from the axis to the edges of a carriageway, seen along the transition.
struct EdgesBeside {
  double left_m, right_m;
};

bool is_road(const Track& track) { return !track.is_rail && values_of(track.surface).group == LandCoverGroup::kRoad; }

// Returns the edges of the way that goes on beyond one end of a transition.
std::optional<EdgesBeside> edges_beyond(const std::vector<Track>& tracks, std::size_t transition, bool is_last,
                                        const EndsOfNode& ends) {
  constexpr double kStraightCosine = -0.7;
  const Track& track = tracks[transition];
  std::optional<EdgesBeside> edges;
  std::tuple<bool, double> best{false, 0};
  for (const TrackEnd& end : ends.at(node_of(track, is_last))) {
    const Track& other = tracks[end.track];
    if (end.track == transition || other.is_transition || !is_road(other)) continue;
    const double cosine = dot(direction_from(track, is_last), direction_from(other, end.is_last));
    const bool is_alike = other.surface == track.surface && other.is_link == track.is_link;
    if (cosine > kStraightCosine || (edges && std::tuple(is_alike, -cosine) <= best)) continue;
    best = {is_alike, -cosine};
    const double left_m = other.section.axis_offset_m, right_m = carriageway_width_m(other.section) - left_m;
    // a way that begins where another begins runs against it
    edges = end.is_last == is_last ? EdgesBeside{right_m, left_m} : EdgesBeside{left_m, right_m};
  }
  return edges;
}

// The distances of the axis from the left edge at which the left edges meet, and at which the right ones do. The first
// is on the inner side, towards oncoming traffic.
std::array<double, 2> offsets_where_edges_meet(const Track& track, const EdgesBeside& beyond) {
  const double width_m = carriageway_width_m(track.section);
  std::array<double, 2> offsets_m = {std::clamp(beyond.left_m, 0.0, width_m),
                                     std::clamp(width_m - beyond.right_m, 0.0, width_m)};
  if (track.side == DrivingSide::kLeft) std::swap(offsets_m[0], offsets_m[1]);
  return offsets_m;
}

// The distances of the axis from the left edge at both ends of a way.
struct EndOffsets {
  double first_m, last_m;
};

EndOffsets least_apart(std::array<double, 2> first_m, std::array<double, 2> last_m) {
  EndOffsets best{first_m[0], last_m[0]};
  for (const double a : first_m)
    for (const double b : last_m)
      if (std::abs(b - a) < std::abs(best.last_m - best.first_m)) best = {a, b};
  return best;
}

void set_offsets(EndOffsets offsets, Track& track) {
  constexpr double kDriftStep = 0x1p-16, kOffsetStep_m = kQuantum_m / 2;
  const double mean_m = (offsets.first_m + offsets.last_m) / 2, length_m = whole_length_m(track);
  double drift = 0;
  if (track.passage == Passage::kGround)
    // towards 0, so that rounding does not take the axis out of the carriageway
    drift =
        std::trunc(std::clamp((offsets.last_m - offsets.first_m) / length_m, -kMostDrift, kMostDrift) / kDriftStep) *
        kDriftStep;
  const bool is_whole = drift != 0 && std::abs(drift) < kMostDrift;
  const double first_m = is_whole ? offsets.first_m : mean_m - drift * length_m / 2;
  track.section.axis_drift = drift;
  track.section.axis_offset_m = std::clamp(snapped_to(kOffsetStep_m, first_m), 0.0, carriageway_width_m(track.section));
}

}  // namespace

void join_transitions(std::vector<Track>& tracks) {
  const EndsOfNode ends = ends_at_transitions(tracks);
  if (ends.empty()) return;
  for (std::size_t t = 0; t < tracks.size(); ++t) {
    if (!can_go_over(tracks[t]) || !is_road(tracks[t])) continue;
    const auto before = edges_beyond(tracks, t, false, ends), after = edges_beyond(tracks, t, true, ends);
    if (!before && !after) continue;
    const auto first_m = offsets_where_edges_meet(tracks[t], before ? *before : *after);
    const auto last_m = offsets_where_edges_meet(tracks[t], after ? *after : *before);
    set_offsets(least_apart(first_m, last_m), tracks[t]);
  }
}

}  // namespace citykiln::map
