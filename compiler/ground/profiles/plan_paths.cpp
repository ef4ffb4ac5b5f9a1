#include "compiler/ground/profiles/plan_paths.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>
#include <vector>

#include "compiler/contract/erase_repeated.h"
#include "compiler/ground/grading/graded_box.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/ground/profiles/crossings/clearances.h"
#include "compiler/ground/profiles/crossings/crossings.h"
#include "compiler/ground/profiles/crossings/enforce_clearances.h"
#include "compiler/ground/profiles/crossings/lower_mouths.h"
#include "compiler/ground/profiles/cuttings.h"
#include "compiler/ground/profiles/diagnose_profiles.h"
#include "compiler/ground/profiles/graph/approach_paths.h"
#include "compiler/ground/profiles/graph/grade_rules.h"
#include "compiler/ground/profiles/plan_profiles.h"
#include "compiler/ground/profiles/planned_spans.h"
#include "compiler/ground/profiles/smoothing/grade_limits.h"
#include "compiler/ground/profiles/smoothing/initial_heights.h"
#include "compiler/ground/profiles/smoothing/profile_knots.h"
#include "compiler/roads/roads_on_ground.h"

namespace citykiln::ground {
namespace {

// ---- clearance shortfalls of stored profiles ------------------------------------------------------------------------

Vec2 place_along(const ProfileGraph& graph, const GraphWay& way, double at_m) {
  const std::uint32_t i = station_before(graph, way, at_m);
  const Station &a = graph.stations[way.first + i], &b = graph.stations[way.first + i + 1];
  const Vec2 from = graph.nodes[a.node].at, to = graph.nodes[b.node].at;
  return from + (to - from) * std::clamp((at_m - a.at_m) / (b.at_m - a.at_m), 0.0, 1.0);
}

struct WrittenHeights {
  const ProfileGraph& graph;
  const Profiles& profiles;
  const BelowBridges& below;

  double height_m(std::uint32_t w, double at_m) const {
    const GraphWay& way = graph.ways[w];
    const Profile& profile = profile_of(profiles, way);
    if (!profile.empty()) return knot_at(profile, at_m).z_m;
    // roads without profile lie at 0, paths without on the ground
    return has_profile(way.track->surface) || way.road == kNone ? 0 : below.ground_m(place_along(graph, way, at_m));
  }

  double shortfall_m(const Crossing& c) const {
    const double lower_m = c.lower == kNone ? c.lower_z_m : height_m(c.lower, c.lower_at_m);
    const double upper_m = c.upper == kNone ? c.upper_z_m : height_m(c.upper, c.upper_at_m);
    return lower_m + c.wanted_m - upper_m;
  }
};

// Returns one shortfall per pair of lines, sorted by ids.
// @param graph  The graph of all lines (Lines::kAll).
std::vector<ClearanceShortfall> find_shortfalls(const ProfileGraph& graph, const map::FeatureView& features,
                                                const Profiles& profiles, const BelowBridges& below) {
  const WrittenHeights heights{graph, profiles, below};
  const auto id_of = [&](std::uint32_t way, OsmId outside) {
    return way == kNone ? outside : graph.ways[way].track->id.osm;
  };
  std::vector<ClearanceShortfall> all;
  for (const Crossing& c : find_crossings(graph, features, below))
    all.push_back({id_of(c.upper, c.outside), id_of(c.lower, c.outside), heights.shortfall_m(c), c.is_contradictory});
  // the largest of a pair first
  std::ranges::sort(all, {}, [](const ClearanceShortfall& s) { return std::tuple(s.upper, s.lower, -s.shortfall_m); });
  erase_repeated(all, [](const ClearanceShortfall& s) { return std::pair(s.upper, s.lower); });
  return all;
}

using map::Track;

/// The height of a step of stairs.
constexpr double kStep_m = 0.25;

// The decided height of a map node that a path shares with a line that has a profile.
struct Decided {
  std::int64_t node_id;
  double z_m;
};

std::vector<Decided> decided_heights(const ProfileGraph& paths, const ProfileGraph& all, const Profiles& profiles) {
  std::vector<std::int64_t> of_paths;
  for (const GraphWay& way : paths.ways)
    of_paths.insert(of_paths.end(), way.track->node_ids.begin(), way.track->node_ids.end());
  std::ranges::sort(of_paths);
  std::vector<Decided> decided;
  for (const GraphWay& way : all.ways) {
    if (!has_profile(way.track->surface)) continue;
    const std::vector<double> along = roads::distances_along(way.track->axis, 0);
    for (std::size_t v = 0; v < along.size(); ++v)
      if (std::ranges::binary_search(of_paths, way.track->node_ids[v]))
        decided.push_back({way.track->node_ids[v], height_m_of(profiles, way, along[v])});
  }
  std::ranges::sort(decided, {}, [](const Decided& d) { return std::tuple(d.node_id, d.z_m); });
  return decided;
}

// Returns heights by node: of the graded land; of lines with a profile where a node is shared; off the ground of the
// line between.
std::vector<double> node_heights_of(const ProfileGraph& paths, const ProfileGraph& all, const Profiles& profiles,
                                    const GradedTerrain& graded) {
  std::vector<double> z_m;
  z_m.reserve(paths.nodes.size());
  for (const GraphNode& node : paths.nodes) z_m.push_back(land_m(graded, node.at));
  const std::vector<Decided> decided = decided_heights(paths, all, profiles);
  for (const GraphWay& way : paths.ways) {
    const std::vector<double> along = roads::distances_along(way.track->axis, 0);
    for (const Station& station : paths.stations_of(way)) {
      const auto v = std::ranges::find(along, station.at_m);
      if (v == along.end()) continue;
      const std::int64_t id = way.track->node_ids[static_cast<std::size_t>(v - along.begin())];
      const auto found = std::ranges::lower_bound(decided, id, {}, &Decided::node_id);
      if (found != decided.end() && found->node_id == id) z_m[station.node] = found->z_m;
    }
  }
  interpolate_spans(paths, z_m);
  return z_m;
}

// Returns the crossings of all lines in terms of the paths' graph: other lines have fixed heights.
std::vector<Crossing> seen_by(const ProfileGraph& paths, const ProfileGraph& all, std::span<const Crossing> crossings,
                              const Profiles& profiles) {
  const auto way_of = [&](std::uint32_t way) {
    if (way == kNone) return kNone;
    const auto id = [](const GraphWay& w) { return w.track->id; };
    const auto found = std::ranges::lower_bound(paths.ways, all.ways[way].track->id, {}, id);
    const bool is_path = found != paths.ways.end() && found->track->id == all.ways[way].track->id;
    return is_path ? static_cast<std::uint32_t>(found - paths.ways.begin()) : kNone;
  };
  std::vector<Crossing> seen;
  for (const Crossing& c : crossings) {
    Crossing path = c;
    path.upper = way_of(c.upper), path.lower = way_of(c.lower);
    if (path.upper == kNone && path.lower == kNone) continue;
    if (path.upper == kNone && c.upper != kNone)
      path.upper_z_m = height_m_of(profiles, all.ways[c.upper], c.upper_at_m);
    if (path.lower == kNone && c.lower != kNone)
      path.lower_z_m = height_m_of(profiles, all.ways[c.lower], c.lower_at_m);
    seen.push_back(path);
  }
  return seen;
}

// Raises the stations between both ends to the upper convex hull (Andrew 1979) of their heights.
void straighten(std::span<const Station> stations, std::vector<double>& z_m) {
  Polyline crests;
  for (const Station& s : stations) {
    const Vec2 here{s.at_m, z_m[s.node]};
    while (crests.size() > 1 && cross(crests.back() - crests[crests.size() - 2], here - crests.back()) >= 0)
      crests.pop_back();
    crests.push_back(here);
  }
  for (std::size_t s = 1, c = 0; s + 1 < stations.size(); ++s) {
    while (c + 2 < crests.size() && crests[c + 1].x <= stations[s].at_m) ++c;
    const double t = (stations[s].at_m - crests[c].x) / (crests[c + 1].x - crests[c].x);
    z_m[stations[s].node] = std::max(z_m[stations[s].node], crests[c].y + (crests[c + 1].y - crests[c].y) * t);
  }
}

// Returns by way whether it passes below another line.
std::vector<bool> pass_below(const ProfileGraph& paths, std::span<const Crossing> crossings) {
  std::vector<bool> below(paths.ways.size());
  for (const Crossing& c : crossings)
    if (c.lower != kNone) below[c.lower] = true;
  return below;
}

// A deck that was raised over several things runs straight from crest to crest between its junctions with other lines,
// unless something passes above it.
void straighten_decks(const ProfileGraph& paths, const std::vector<bool>& is_below, std::vector<double>& z_m) {
  for (std::size_t w = 0; w < paths.ways.size(); ++w) {
    const GraphWay& way = paths.ways[w];
    if (way.track->passage != map::Passage::kBridge || is_below[w]) continue;
    const std::span<const Station> stations = paths.stations_of(way);
    for (std::size_t first = 0, s = 1; s < stations.size(); ++s) {
      const GraphNode& node = paths.nodes[stations[s].node];
      if (s + 1 < stations.size() && !node.is_pinned && node.legs == 2) continue;
      straighten(stations.subspan(first, s - first + 1), z_m);
      first = s;
    }
  }
}

// Returns whether a station moved by more than by_m. Paths that no clearance moved, and no grade limit by more than a
// step, need no profile, unless they pass below something: embankments beside them would lift them.
bool is_moved(const ProfileGraph& paths, const GraphWay& way, std::span<const double> from_m,
              std::span<const double> to_m, double by_m) {
  return std::ranges::any_of(paths.stations_of(way),
                             [&](const Station& s) { return std::abs(to_m[s.node] - from_m[s.node]) > by_m; });
}

// Reports each pair of lines, and whether the map or the plan is at fault.
void report_shortfalls(std::span<const ClearanceShortfall> shortfalls, Report& report) {
  for (const ClearanceShortfall& s : shortfalls)
    if (s.shortfall_m > kShortfallMargin_m)
      report.add_pair(s.is_contradictory ? Code::kLayersContradict : Code::kClearanceNotMet, s.upper, s.lower,
                      s.shortfall_m);
}

}  // namespace

Profiles plan_paths(const map::FeatureView& features, Profiles profiles, const TerrainWithoutRoads& terrain,
                    Report& report) {
  const ProfileGraph paths = graph_of(features, profiles.roads, {}, Lines::kPaths);
  const ProfileGraph all = graph_of(features, profiles.roads, {}, Lines::kAll);
  const PlannedSpans spans = planned_spans(features, profiles, terrain.heights);
  const GradedTerrain graded = grade_terrain(terrain.heights, {.roads = profiles.roads,
                                                               .streams = terrain.streams,
                                                               .surfaces = terrain.waters,
                                                               .box = graded_box(features.extent, terrain.heights),
                                                               .has_kerbs = false,
                                                               .decks = spans.decks,
                                                               .bores = spans.bores,
                                                               .landforms = terrain.landforms});
  const BelowBridges below{terrain.streams, terrain.waters, [&](Vec2 p) { return land_m(graded, p); }};
  const std::vector<Crossing> crossings = seen_by(paths, all, find_crossings(all, features, below), profiles);
  const std::vector<double> lines_m = node_heights_of(paths, all, profiles, graded);
  const std::vector<double> mouths_m = lower_mouths(paths, features, terrain.heights, lines_m);
  const std::vector<double> cleared_m = clear_crossings(paths, crossings, &terrain.heights, mouths_m);
  std::vector<double> z_m = enforce_clearances(paths, crossings, lines_m, limit_grades(paths, cleared_m));
  const std::vector<bool> is_below = pass_below(paths, crossings);
  straighten_decks(paths, is_below, z_m);
  diagnose_profiles(paths, lines_m, z_m, report);
  const JunctionPlanes planes{std::move(z_m), std::vector<Vec2>(paths.nodes.size())};
  std::vector<std::vector<roads::Cutting>> cuttings = cuttings_of(paths, lines_m, planes.z_m);
  for (std::size_t w = 0; w < paths.ways.size(); ++w) {
    const GraphWay& way = paths.ways[w];
    if (way.road == kNone) {
      profiles.off_ground[way.off_ground] = knots_of(paths, way, planes);
    } else if (is_below[w] || is_moved(paths, way, lines_m, cleared_m, kKnotError_m) ||
               is_moved(paths, way, lines_m, planes.z_m, kStep_m)) {
      profiles.roads[way.road].profile = knots_of(paths, way, planes);
      profiles.roads[way.road].cuttings = std::move(cuttings[w]);
    }
  }
  const ProfileGraph written = graph_of(features, profiles.roads, {}, Lines::kAll);
  profiles.shortfalls = find_shortfalls(written, features, profiles, below);
  report_shortfalls(profiles.shortfalls, report);
  for (const UnorderedPair& pair : find_unordered(written, features))
    report.add_pair(Code::kCrossingWithoutOrder, pair.first, pair.second, 0);
  return profiles;
}

}  // namespace citykiln::ground
