#include "compiler/things/contact_tracks.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>

#include "compiler/geometry/segment.h"

namespace citykiln::things {
namespace {

constexpr double kTrackBucket_m = 32, kIntegration_m = 5, kSpanStep_m = 5;
constexpr double kParallelTracks = 0.94;  // the cosine of 20 degrees
constexpr double kShortestWay = 0.4;      // in spans

bool is_in_open(const map::Track& track) {
  return track.passage != map::Passage::kTunnel && !track.is_indoor && track.axis.size() > 1 && track.is_rail;
}

ContactTrack contact_track_of(const map::Track& track) {
  return {.id = track.id,
          .axis = track.axis,
          .along_m = roads::distances_along(track.axis, 0),
          .node_ids = track.node_ids,
          .is_tram = track.surface == map::LandCoverClass::kTram || track.surface == map::LandCoverClass::kStreetRails,
          .is_on_bridge = track.passage == map::Passage::kBridge,
          .has_contact_line = track.has_contact_line && !track.is_covered && !track.is_through_building};
}

void add_segments(TrackIndex& index) {
  std::vector<Box2> boxes;
  for (std::uint32_t t = 0; t < index.tracks.size(); ++t) {
    const Polyline& axis = index.tracks[t].axis;
    for (std::uint32_t v = 0; v + 1 < axis.size(); ++v) {
      index.segments.push_back({t, v});
      boxes.push_back(box_of_segment(axis[v], axis[v + 1]));
    }
  }
  index.grid = grid_of(boxes, kTrackBucket_m);
}

// The part whose profile covers a distance along the way.
const roads::Road* part_at(const ContactTrack& track, double along_m) {
  for (const roads::Road* part : track.parts) {
    if (part->profile.empty()) continue;
    if (along_m >= part->start_along_m && along_m <= part->start_along_m + length_m(part->axis) + 1) return part;
  }
  return nullptr;
}

}  // namespace

TrackIndex index_tracks(const map::FeatureView& features, std::span<const roads::Road> roads,
                        std::span<const structures::Span> bridges) {
  TrackIndex index;
  for (const map::Track& track : features.tracks)
    if (is_in_open(track)) index.tracks.push_back(contact_track_of(track));
  std::ranges::sort(index.tracks, {}, &ContactTrack::id);
  const auto add_part = [&](const roads::Road& road) {
    const auto found =
        std::ranges::lower_bound(index.tracks, road.id.osm, {}, [](const ContactTrack& track) { return track.id.osm; });
    if (found != index.tracks.end() && found->id.osm == road.id.osm) found->parts.push_back(&road);
  };
  for (const roads::Road& road : roads) add_part(road);
  for (const structures::Span& bridge : bridges) add_part(bridge);
  add_segments(index);
  return index;
}

AxisPlace place_at(const ContactTrack& track, double along_m) {
  const auto next = std::ranges::upper_bound(track.along_m, along_m);
  const auto end = static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(next - track.along_m.begin(), 1, static_cast<std::ptrdiff_t>(track.axis.size()) - 1));
  const Vec2 a = track.axis[end - 1], b = track.axis[end];
  const double long_m = track.along_m[end] - track.along_m[end - 1];
  const double share = long_m > 0 ? std::clamp((along_m - track.along_m[end - 1]) / long_m, 0.0, 1.0) : 0;
  return {a + (b - a) * share, unit(b - a)};
}

double track_height_m(const ContactTrack& track, double along_m, const ground::GradedTerrain& ground) {
  if (const roads::Road* part = part_at(track, along_m)) return knot_at(part->profile, along_m).z_m;
  return land_m(ground, place_at(track, along_m).at);
}

double longest_span_m(const ContactTrack& track, double along_m) {
  const Vec2 middle = place_at(track, along_m).at;
  double span_m = track.is_tram ? kTramSpan_m : kRailSpan_m;
  for (; span_m > kShortestContactSpan_m; span_m -= kSpanStep_m) {
    const Vec2 from = place_at(track, along_m - span_m / 2).at, to = place_at(track, along_m + span_m / 2).at;
    if (distance_to_segment(from, to, middle) <= kCurveOffset_m) break;
  }
  return span_m;
}

std::vector<double> stations_of(const ContactTrack& track) {
  const double length_m = track.along_m.back();
  const int steps = std::max(1, static_cast<int>(std::ceil(length_m / kIntegration_m)));
  const double step_m = length_m / steps;
  std::vector<double> spans(1, 0);  // the number of spans up to each step
  for (int i = 0; i < steps; ++i) spans.push_back(spans.back() + step_m / longest_span_m(track, (i + 0.5) * step_m));
  if (spans.back() < kShortestWay) return {};
  // sums of shares such as 1 / 12 are not exact
  const int count = std::max(1, static_cast<int>(std::ceil(spans.back() - 1e-6)));
  std::vector<double> stations;
  for (int i = 0, step = 0; i < count; ++i) {
    const double target = spans.back() * (i + 0.5) / count;
    while (step + 1 < steps && spans[static_cast<std::size_t>(step) + 1] < target) ++step;
    const double from = spans[static_cast<std::size_t>(step)], to = spans[static_cast<std::size_t>(step) + 1];
    stations.push_back((step + (target - from) / (to - from)) * step_m);
  }
  return stations;
}

std::vector<SectionTrack> section_at(const TrackIndex& index, std::uint32_t own, double along_m) {
  const ContactTrack& track = index.tracks[own];
  const AxisPlace station = place_at(track, along_m);
  const Vec2 left = left_of(station.along), from = station.at - left * kSection_m, to = station.at + left * kSection_m;
  std::vector<SectionTrack> all{{0, own, along_m}};
  for (const std::uint32_t i : boxes_about(index.grid, box_of_segment(from, to))) {
    const auto [t, v] = index.segments[i];
    const ContactTrack& other = index.tracks[t];
    if (t == own || other.is_tram != track.is_tram || other.is_on_bridge != track.is_on_bridge) continue;
    const Vec2 a = other.axis[v], b = other.axis[v + 1];
    const auto shares = crossing_shares(from, to, a, b);
    if (!shares || std::abs(dot(unit(b - a), station.along)) < kParallelTracks) continue;
    all.push_back({(2 * shares->first - 1) * kSection_m, t,
                   other.along_m[v] + (other.along_m[v + 1] - other.along_m[v]) * shares->second});
  }
  std::ranges::sort(all, {}, [](const SectionTrack& s) { return std::tuple(s.left_m, s.track, s.along_m); });
  const auto self = std::ranges::find(all, own, &SectionTrack::track);
  auto first = self, last = self;
  while (first != all.begin() && first->left_m - std::prev(first)->left_m <= kTracksApart_m) --first;
  while (std::next(last) != all.end() && std::next(last)->left_m - last->left_m <= kTracksApart_m) ++last;
  std::vector<SectionTrack> group(first, std::next(last));
  // a way that crosses at a vertex, or twice, counts once
  std::vector<SectionTrack> once;
  for (const SectionTrack& s : group)
    if (std::ranges::find(once, s.track, &SectionTrack::track) == once.end()) once.push_back(s);
  return once;
}

double distance_to_tracks(const TrackIndex& index, Vec2 p, bool of_trams, double search_m) {
  double least_m = search_m;
  for (const std::uint32_t i : boxes_about(index.grid, Box2{p, p}.widened(search_m))) {
    const auto [t, v] = index.segments[i];
    const ContactTrack& track = index.tracks[t];
    if (track.is_tram != of_trams || track.is_on_bridge) continue;
    least_m = std::min(least_m, distance_to_segment(track.axis[v], track.axis[v + 1], p));
  }
  return least_m;
}

}  // namespace citykiln::things
