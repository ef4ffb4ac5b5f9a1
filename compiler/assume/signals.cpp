#include "compiler/assume/signals.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/snap.h"

namespace citykiln::assume {
namespace {

constexpr std::string_view kSignalsThing = "traffic_signals";

// The cosines of arms that go straight on, and across.
constexpr double kStraightOn = -0.8, kAcross = 0.75;

bool is_street_with_signals(const map::Track& track) {
  const bool is_main =
      track.surface == map::LandCoverClass::kPrimaryRoad || track.surface == map::LandCoverClass::kSecondaryRoad;
  return is_main && track.passage == map::Passage::kGround && !track.is_roundabout && !track.is_link;
}

// A node of main streets.
struct MainNode {
  Vec2 at;
  map::CountryGroup country{};
  std::vector<Vec2> arms;  // directions of length 1
};

std::map<std::int64_t, MainNode> main_nodes(std::span<const map::Track> tracks) {
  std::map<std::int64_t, MainNode> nodes;
  for (const map::Track& track : tracks) {
    if (!is_street_with_signals(track)) continue;
    for (std::size_t i = 0; i < track.axis.size(); ++i) {
      MainNode& node = nodes[track.node_ids[i]];
      node.at = track.axis[i], node.country = track.country;
      if (i > 0) node.arms.push_back(unit(track.axis[i - 1] - track.axis[i]));
      if (i + 1 < track.axis.size()) node.arms.push_back(unit(track.axis[i + 1] - track.axis[i]));
    }
  }
  return nodes;
}

bool is_crossed(const std::vector<Vec2>& arms) {
  for (std::size_t a = 0; a < arms.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      if (dot(arms[a], arms[b]) >= kStraightOn) continue;
      const auto crosses = [&](Vec2 arm) {
        return std::abs(dot(arm, arms[a])) < kAcross && std::abs(dot(arm, arms[b])) < kAcross;
      };
      if (std::ranges::any_of(arms, crosses)) return true;
    }
  return false;
}

// Points with a grid.
struct Places {
  std::vector<Vec2> all;
  BoxGrid grid;
  double radius_m = 0;

  int count_near(Vec2 p) const {
    return static_cast<int>(
        std::ranges::count_if(boxes_about(grid, p), [&](std::uint32_t i) { return distance(all[i], p) < radius_m; }));
  }
};

Places places_of(std::vector<Vec2> all, double radius_m) {
  std::vector<Box2> boxes;
  for (const Vec2 p : all) boxes.push_back(Box2{p, p}.widened(radius_m));
  return {std::move(all), grid_of(boxes, 2 * radius_m), radius_m};
}

Places mapped_signals(const map::FeatureView& features) {
  std::vector<Vec2> all;
  for (const map::ThingFeature& thing : features.things)
    if (thing.kind == kSignalsThing) all.push_back(thing.at);
  for (const map::Track& track : features.tracks)
    for (const map::TrackPoint& point : track.points)
      if (point.kind == map::TrackPointKind::kSignals) all.push_back(track.axis[point.vertex]);
  return places_of(std::move(all), kNoneMapped_m);
}

Places houses(const map::FeatureView& features) {
  std::vector<Vec2> all;
  for (const map::Footprint& footprint : features.footprints)
    if (!footprint.is_part && !footprint.polygon.outer.empty()) all.push_back(footprint.polygon.outer.front());
  return places_of(std::move(all), kHousesWithin_m);
}

map::ThingFeature signals_thing(std::int64_t node_id, const MainNode& node) {
  constexpr double kWidth_m = 0.5, kDepth_m = 0.8, kHeight_m = 3.6;  // of the row of things.txt
  map::ThingFeature thing;
  thing.id = {{OsmType::kNode, node_id}, 0};
  thing.at = node.at, thing.country = node.country;
  thing.kind = thing.value = kSignalsThing;
  thing.width_m = snapped(kWidth_m), thing.depth_m = snapped(kDepth_m), thing.height_m = snapped(kHeight_m);
  return thing;
}

void add_points(const std::map<std::int64_t, MainNode>& signals, map::Track& track, Report& report) {
  const std::size_t before = track.points.size();
  for (std::uint32_t i = 0; i < track.axis.size(); ++i)
    if (signals.contains(track.node_ids[i]))
      track.points.push_back({.vertex = i, .kind = map::TrackPointKind::kSignals});
  if (track.points.size() == before) return;
  std::ranges::sort(track.points);
  track.assumed |= bit_of(Assumption::kRoadsides);
  report.count_assumed(Assumption::kRoadsides, track.id.osm);
}

}  // namespace

WithSignals assume_signals(const map::FeatureView& features, Report& report) {
  WithSignals made{.tracks = {features.tracks.begin(), features.tracks.end()},
                   .things = {features.things.begin(), features.things.end()}};
  std::map<std::int64_t, MainNode> nodes = main_nodes(features.tracks);
  std::erase_if(nodes, [](const auto& node) { return node.second.arms.size() < 3 || !is_crossed(node.second.arms); });
  if (nodes.empty()) return made;
  const Places mapped = mapped_signals(features), built = houses(features);
  std::erase_if(nodes, [&](const auto& node) {
    return mapped.count_near(node.second.at) > 0 || built.count_near(node.second.at) < kLeastHouses;
  });
  for (const auto& [id, node] : nodes) made.things.push_back(signals_thing(id, node));
  std::ranges::stable_sort(made.things, {}, &map::ThingFeature::id);
  for (map::Track& track : made.tracks)
    if (is_street_with_signals(track)) add_points(nodes, track, report);
  return made;
}

}  // namespace citykiln::assume
