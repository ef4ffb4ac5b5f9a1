#include "compiler/roads/roads_on_ground.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <tuple>

#include "compiler/contract/equal_span.h"
#include "compiler/contract/erase_repeated.h"
#include "compiler/roads/kerb_parking.h"

namespace citykiln::roads {

Road road_of(const map::Track& track) {
  return {.id = track.id,
          .axis = track.axis,
          .surface = track.surface,
          .section = track.section,
          .side = track.side,
          .is_lit = track.is_lit,
          .is_link = track.is_link,
          .is_roundabout = track.is_roundabout,
          .points = track.points,
          .width_limits = {},
          .country = track.country,
          .assumed = track.assumed,
          .assumed_sides = track.assumed_sides,
          .kerb_parking = kerb_parking_of(track)};
}

namespace {

// A way for feet or wheels at a map node.
struct CrossingWay {
  std::int64_t node = 0;
  double width_m = 0;
  Vec2 along;
};

Vec2 direction_at(const map::Track& track, std::size_t v) {
  return unit(track.axis[std::min(v + 1, track.axis.size() - 1)] - track.axis[v > 0 ? v - 1 : 0]);
}

// The nodes of level crossings, sorted.
std::vector<std::int64_t> level_crossings(const map::FeatureView& features) {
  std::vector<std::int64_t> nodes;
  for (const map::Track& track : features.tracks)
    for (const map::TrackPoint& point : track.points)
      if (track.is_rail && point.kind == map::TrackPointKind::kLevelCrossing)
        nodes.push_back(track.node_ids[point.vertex]);
  sort_unique(nodes);
  return nodes;
}

std::vector<CrossingWay> crossing_ways(const map::FeatureView& features, std::span<const std::int64_t> nodes) {
  std::vector<CrossingWay> ways;
  for (const map::Track& track : features.tracks) {
    if (track.is_rail || track.passage != map::Passage::kGround) continue;
    for (std::size_t v = 0; v < track.node_ids.size(); ++v)
      if (std::ranges::binary_search(nodes, track.node_ids[v]))
        ways.push_back({track.node_ids[v], map::total_width_m(track.section), direction_at(track, v)});
  }
  std::ranges::sort(ways, {}, [](const CrossingWay& w) { return std::tuple(w.node, w.width_m, w.along.x, w.along.y); });
  return ways;
}

// The length of rails, on either side of a node, between the edges of a way that crosses them.
double rails_below_m(const CrossingWay& way, Vec2 along_rails) {
  constexpr double kHalfSleeper_m = 1.3, kLeastSine = 0.3, kBeside_m = 0.25;
  const double sine = std::max(kLeastSine, std::abs(cross(way.along, along_rails)));
  const double cosine = std::abs(dot(way.along, along_rails));
  return (way.width_m / 2 + kHalfSleeper_m * cosine) / sine + kBeside_m;
}

void set_reach(const map::Track& rails, std::span<const CrossingWay> ways, Road& road) {
  for (map::TrackPoint& point : road.points) {
    if (point.kind != map::TrackPointKind::kLevelCrossing) continue;
    double reach_m = 0;
    for (const CrossingWay& way : equal_span(ways, rails.node_ids[point.vertex], &CrossingWay::node))
      reach_m = std::max(reach_m, rails_below_m(way, direction_at(rails, point.vertex)));
    point.reach_quarters = static_cast<std::uint8_t>(std::min(255.0, std::ceil(reach_m * 4)));
  }
}

}  // namespace

std::vector<Road> roads_on_ground(const map::FeatureView& features, Report& report) {
  std::vector<Road> roads;
  Account account;
  const std::vector<CrossingWay> crossing = crossing_ways(features, level_crossings(features));
  for (const map::Track& track : features.tracks) {
    const bool counts = report.counts(track.id.osm);
    account.in += counts;
    // bridges and tunnels become structures
    if (track.passage != map::Passage::kGround) {
      account.merged += counts;
      continue;
    }
    account.out += counts;
    roads.push_back(road_of(track));
    if (track.is_rail) set_reach(track, crossing, roads.back());
  }
  report.account("roads", "track") = account;
  return roads;
}

std::vector<OsmId> ways_through_buildings(std::span<const map::Track> tracks,
                                          std::span<const map::Passageway> passageways) {
  std::vector<OsmId> ids;
  for (const map::Track& track : tracks)
    if (track.is_through_building) ids.push_back(track.id.osm);
  for (const map::Passageway& passageway : passageways) ids.push_back(passageway.way.osm);
  std::ranges::sort(ids);
  return ids;
}

}  // namespace citykiln::roads
