#include "compiler/ground/profiles/smoothing/junction_planes.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compiler/ground/profiles/graph/graph_rules.h"
#include "compiler/ground/profiles/graph/graph_walk.h"

namespace citykiln::ground {
namespace {

struct FittedPlane {
  Vec2 centre, gradient;
  double z_m = 0;
  double height_m(Vec2 at) const { return z_m + dot(gradient, at - centre); }
};

// Weights rise with the square of the class's rank: a motorway's is about a hundred times a farm track's.
double weight_of(const ProfileGraph& graph, std::uint32_t node) {
  double weight = 0;
  for (const Leg& leg : graph.legs_of(node)) {
    const int above_tracks = map::values_of(graph.ways[leg.way].track->surface).priority - 78;
    const double rank = 1 + std::max(above_tracks, 0);
    weight += rank * rank * std::min(leg.length_m, kStation_m);
  }
  return std::max(weight, 1e-6);
}

// Weighted least squares about the centroid, with a regularisation of 1 m² per unit of weight: across a single line the
// plane is level.
FittedPlane plane_of(const ProfileGraph& graph, std::span<const std::uint32_t> nodes, std::span<const double> z_m) {
  double sum = 0;
  FittedPlane plane;
  for (const std::uint32_t n : nodes) {
    const double w = weight_of(graph, n);
    sum += w, plane.centre = plane.centre + graph.nodes[n].at * w, plane.z_m += w * z_m[n];
  }
  plane.centre = plane.centre * (1 / sum), plane.z_m /= sum;
  double xx = sum, xy = 0, yy = sum, xz = 0, yz = 0;
  for (const std::uint32_t n : nodes) {
    const double w = weight_of(graph, n), dz = z_m[n] - plane.z_m;
    const Vec2 d = graph.nodes[n].at - plane.centre;
    xx += w * d.x * d.x, xy += w * d.x * d.y, yy += w * d.y * d.y, xz += w * d.x * dz, yz += w * d.y * dz;
  }
  const double area = xx * yy - xy * xy;
  plane.gradient = Vec2{xz * yy - yz * xy, yz * xx - xz * xy} * (1 / area);
  double most = kPlaneSlope;
  for (const std::uint32_t n : nodes)
    for (const Leg& leg : graph.legs_of(n)) most = std::min(most, limit_of(graph, leg));
  const double slope = length(plane.gradient);
  if (slope > most) plane.gradient = plane.gradient * (most / slope);
  return plane;
}

std::vector<std::vector<std::uint32_t>> nodes_by_junction(const ProfileGraph& graph) {
  std::vector<std::vector<std::uint32_t>> nodes;
  for (std::uint32_t n = 0; n < graph.nodes.size(); ++n) {
    const std::uint32_t j = graph.nodes[n].junction;
    if (j == kNone) continue;
    if (j >= nodes.size()) nodes.resize(j + 1);
    nodes[j].push_back(n);
  }
  return nodes;
}

// Fades the nodes' moves out along the network: all of it near a junction, nothing at the end of its spread, between
// two junctions a blend.
void ease(const ProfileGraph& graph, std::span<const double> moved_m, std::vector<double>& z_m) {
  std::vector<double> sum(z_m.size()), weight(z_m.size());
  GraphWalk walk(graph);
  for (std::uint32_t n = 0; n < z_m.size(); ++n) {
    const auto leads_off = [&](const Leg& leg) { return graph.nodes[leg.to].junction == kNone; };
    if (graph.nodes[n].junction == kNone || !std::ranges::any_of(graph.legs_of(n), leads_off)) continue;
    const double spread_m = std::clamp(kSpread * std::abs(moved_m[n]), kMinSpread_m, kMaxSpread_m);
    walk.from(
        n, spread_m, [](const Leg& leg) { return leg.length_m; },
        [&](std::uint32_t node, double run_m) {
          if (node == n) return true;
          if (graph.nodes[node].junction != kNone) return false;
          const double left = 1 - run_m / spread_m, w = left * left * spread_m / run_m;
          sum[node] += w * moved_m[n];
          weight[node] += w;
          return true;
        });
  }
  for (std::uint32_t n = 0; n < z_m.size(); ++n)
    if (weight[n] > 0 && !graph.nodes[n].is_pinned) z_m[n] += sum[n] / (weight[n] + 1);
}

}  // namespace

JunctionPlanes fit_junction_planes(const ProfileGraph& graph, std::span<const double> z_m) {
  assert(z_m.size() == graph.nodes.size());
  JunctionPlanes planes{{z_m.begin(), z_m.end()}, std::vector<Vec2>(z_m.size())};
  std::vector<double> moved_m(z_m.size());
  for (const std::vector<std::uint32_t>& nodes : nodes_by_junction(graph)) {
    const auto is_level = [&](std::uint32_t n) { return z_m[n] == z_m[nodes.front()]; };
    if (std::ranges::all_of(nodes, is_level)) continue;
    const FittedPlane plane = plane_of(graph, nodes, z_m);
    for (const std::uint32_t n : nodes) {
      planes.z_m[n] = plane.height_m(graph.nodes[n].at);
      planes.gradient[n] = plane.gradient;
      moved_m[n] = planes.z_m[n] - z_m[n];
    }
  }
  if (std::ranges::any_of(moved_m, [](double m) { return m != 0; })) ease(graph, moved_m, planes.z_m);
  return planes;
}

}  // namespace citykiln::ground
