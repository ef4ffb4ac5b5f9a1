#include "compiler/ground/profiles/plan_profiles.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compiler/ground/profiles/clearances.h"
#include "compiler/ground/profiles/grade_limits.h"
#include "compiler/ground/profiles/grade_rules.h"
#include "compiler/ground/profiles/graph_walk.h"
#include "compiler/ground/profiles/initial_heights.h"
#include "compiler/ground/profiles/plan_paths.h"
#include "compiler/ground/profiles/profile_knots.h"
#include "compiler/ground/profiles/smooth_profile.h"

namespace citykiln::ground {
namespace {

/// Raising a bridge tilts junction planes, and the grade limit takes back part of its clearance. One more pass restores
/// it, in which ramps may exceed the limit by this factor: as much as raising makes them on slopes.
constexpr double kSteepest = 1.375;
// Smaller excess over the limit is rounding.
constexpr double kSteepMargin = 0.005;
// Smoothing alone lowers tunnels by about this.
constexpr double kDugMargin_m = 2;

void report_steep(const ProfileGraph& graph, std::span<const double> z_m, Report& report) {
  for (const GraphWay& way : graph.ways) {
    const double limit = graph.limit_scale * grade_rule_of(way.track->surface).limit;
    const std::span<const Station> stations = graph.stations_of(way);
    double steepest = 0;
    for (std::size_t s = 1; s < stations.size(); ++s) {
      const double run_m = std::max(stations[s].at_m - stations[s - 1].at_m, 1.0);
      steepest = std::max(steepest, std::abs(z_m[stations[s].node] - z_m[stations[s - 1].node]) / run_m);
    }
    if (steepest > limit + kSteepMargin) report.add(Code::kTooSteep, way.track->id.osm, steepest);
  }
}

// Reports how far below the line between its mouths a tunnel was lowered.
void report_lowered_tunnels(const ProfileGraph& graph, std::span<const double> lines_m, std::span<const double> z_m,
                            Report& report) {
  for (const GraphWay& way : graph.ways) {
    if (way.track->passage != map::Passage::kTunnel) continue;
    double deepest_m = 0;
    for (const Station& station : graph.stations_of(way)) {
      deepest_m = std::max(deepest_m, lines_m[station.node] - z_m[station.node]);
    }
    if (deepest_m > kDugMargin_m) report.add(Code::kTunnelLowered, way.track->id.osm, deepest_m);
  }
}

void report_free_ends(const ProfileGraph& graph, Report& report) {
  for (const GraphWay& way : graph.ways) {
    if (way.track->passage != map::Passage::kBridge) continue;
    const std::span<const Station> stations = graph.stations_of(way);
    for (const Station& end : {stations.front(), stations.back()})
      if (graph.nodes[end.node].is_free_end) report.add(Code::kBridgeWithoutGround, way.track->id.osm);
  }
}

// Returns whether the way and the terrain below it lie at height 0 throughout.
bool is_level_zero(const ProfileGraph& graph, const GraphWay& way, const JunctionPlanes& planes,
                   const map::Heightfield& heights) {
  return std::ranges::all_of(graph.stations_of(way), [&](const Station& s) {
    return planes.z_m[s.node] == 0 && planes.gradient[s.node] == Vec2{} &&
           height_m_at(heights, graph.nodes[s.node].at) == 0;
  });
}

// Returns the crossings that can be cleared by moving only ways that may be steeper.
std::vector<Crossing> of_streets(const ProfileGraph& graph, std::span<const Crossing> crossings) {
  std::vector<Crossing> of_streets;
  const auto keeps = [&](std::uint32_t way, map::Passage moving) {
    return way == kNone || graph.ways[way].track->passage != moving || may_be_steeper(graph, way);
  };
  for (const Crossing& c : crossings)
    if (keeps(c.upper, map::Passage::kBridge) && keeps(c.lower, map::Passage::kTunnel)) of_streets.push_back(c);
  return of_streets;
}

JunctionPlanes solve(const ProfileGraph& graph, std::span<const Crossing> crossings, const map::Heightfield& heights,
                     std::span<const double> lines_m) {
  JunctionPlanes planes = fit_junction_planes(graph, smooth_heights(graph, lines_m, heights.longer_step_m()));
  planes.z_m = limit_grades(graph, planes.z_m);
  planes = fit_junction_planes(graph, clear_crossings(graph, crossings, &heights, planes.z_m));
  planes.z_m = limit_grades(graph, planes.z_m);
  const std::vector<double> cleared_m = clear_crossings(graph, of_streets(graph, crossings), nullptr, planes.z_m);
  if (cleared_m == planes.z_m) return planes;
  std::vector<double> steepness;
  for (std::size_t n = 0; n < cleared_m.size(); ++n) steepness.push_back(cleared_m[n] == planes.z_m[n] ? 1 : kSteepest);
  planes = fit_junction_planes(graph, cleared_m);
  planes.z_m = limit_grades(graph, planes.z_m, steepness);
  return planes;
}

}  // namespace

const Profile& profile_of(const Profiles& profiles, const GraphWay& way) {
  return way.road == kNone ? profiles.off_ground[way.off_ground] : profiles.roads[way.road].profile;
}

double height_m_of(const Profiles& profiles, const GraphWay& way, double at_m) {
  const Profile& profile = profile_of(profiles, way);
  return profile.empty() ? 0 : knot_at(profile, at_m).z_m;
}

Profiles plan_profiles(const map::Features& features, std::vector<roads::Road> roads,
                       std::span<const roads::Junction> junctions, std::span<const roads::Strip> streams,
                       std::span<const LandCoverPolygon> waters, const map::Heightfield& heights, Report& report,
                       double limit_scale) {
  assert(limit_scale > 0);
  ProfileGraph graph = graph_of(features, roads, junctions);
  graph.limit_scale = limit_scale;
  const std::vector<Crossing> crossings =
      find_crossings(graph, features, {streams, waters, [&](Vec2 p) { return height_m_at(heights, p); }});
  const std::vector<double> lines_m = initial_heights(graph, heights);
  const JunctionPlanes planes = solve(graph, crossings, heights, lines_m);

  Profiles profiles{std::move(roads), {}, {}};
  profiles.off_ground.resize(static_cast<std::size_t>(std::ranges::count_if(features.tracks, leaves_ground)));
  for (const GraphWay& way : graph.ways) {
    if (way.road == kNone) {
      profiles.off_ground[way.off_ground] = knots_of(graph, way, planes);
    } else if (!is_level_zero(graph, way, planes, heights)) {
      profiles.roads[way.road].profile = knots_of(graph, way, planes);
    }
  }
  report_steep(graph, planes.z_m, report);
  report_lowered_tunnels(graph, lines_m, planes.z_m, report);
  report_free_ends(graph, report);
  return plan_paths(features, std::move(profiles), {streams, waters, heights}, report);
}

}  // namespace citykiln::ground
