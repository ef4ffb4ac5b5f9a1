#include "compiler/ground/profiles/diagnose_profiles.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compiler/ground/profiles/graph/grade_rules.h"

namespace citykiln::ground {
namespace {

// Smaller excess over the limit is rounding.
constexpr double kSteepMargin = 0.005;
// Smoothing alone lowers tunnels by about this.
constexpr double kDugMargin_m = 2;

bool is_decided(const ProfileGraph& graph, const GraphWay& way) {
  return graph.lines == Lines::kGraded ? has_profile(way.track->surface) : leaves_ground(*way.track);
}

double steepest_of(const ProfileGraph& graph, const GraphWay& way, std::span<const double> z_m) {
  const std::span<const Station> stations = graph.stations_of(way);
  double steepest = 0;
  for (std::size_t s = 1; s < stations.size(); ++s) {
    const double run_m = std::max(stations[s].at_m - stations[s - 1].at_m, 1.0);
    steepest = std::max(steepest, std::abs(z_m[stations[s].node] - z_m[stations[s - 1].node]) / run_m);
  }
  return steepest;
}

// How far below the line between its mouths a tunnel was lowered.
double deepest_m_of(const ProfileGraph& graph, const GraphWay& way, std::span<const double> lines_m,
                    std::span<const double> z_m) {
  double deepest_m = 0;
  for (const Station& station : graph.stations_of(way))
    deepest_m = std::max(deepest_m, lines_m[station.node] - z_m[station.node]);
  return deepest_m;
}

}  // namespace

void diagnose_profiles(const ProfileGraph& graph, std::span<const double> lines_m, std::span<const double> z_m,
                       Report& report) {
  assert(lines_m.size() == graph.nodes.size() && z_m.size() == graph.nodes.size());
  for (const GraphWay& way : graph.ways) {
    if (!is_decided(graph, way)) continue;
    const double limit = graph.limit_scale * grade_rule_of(way.track->surface).limit;
    const double steepest = steepest_of(graph, way, z_m);
    if (steepest > limit + kSteepMargin) report.add(Code::kTooSteep, way.track->id.osm, steepest);
    if (way.track->passage != map::Passage::kTunnel) continue;
    const double deepest_m = deepest_m_of(graph, way, lines_m, z_m);
    if (deepest_m > kDugMargin_m) report.add(Code::kTunnelLowered, way.track->id.osm, deepest_m);
  }
}

}  // namespace citykiln::ground
