#include "compiler/ground/profiles/smoothing/initial_heights.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

#include "compiler/ground/profiles/graph/graph_walk.h"
#include "compiler/ground/profiles/smoothing/grade_limits.h"

namespace citykiln::ground {
namespace {

// Returns how far the filter moves a sample: a single high or low one becomes the median of the samples about it.
double correction_m(const map::Heightfield& terrain, int i, int j) {
  const auto sample_m = [&](int di, int dj) {
    return terrain.height_m_at_vertex(std::clamp(i + di * terrain.parts, 0, terrain.columns - 1),
                                      std::clamp(j + dj * terrain.parts, 0, terrain.rows - 1));
  };
  std::array<double, 24> about{};
  std::size_t n = 0;
  for (int dj = -2; dj <= 2; ++dj)
    for (int di = -2; di <= 2; ++di)
      if (di != 0 || dj != 0) about[n++] = sample_m(di, dj);
  std::ranges::nth_element(about, about.begin() + 12);
  const double above_m = sample_m(0, 0) - about[12];
  const double most_m = std::max(kMinSummit_m, kMaxSummitSlope * terrain.longer_sample_step_m());
  return std::abs(above_m) > most_m ? -above_m : 0;
}

bool is_ground(const ProfileGraph& graph, std::uint32_t node) {
  return graph.nodes[node].is_on_ground || graph.nodes[node].is_pinned;
}

bool is_in_tunnel(const ProfileGraph& graph, std::uint32_t node) {
  return std::ranges::all_of(
      graph.legs_of(node), [&](const Leg& leg) { return graph.ways[leg.way].track->passage == map::Passage::kTunnel; });
}

// Tunnels without a mouth stay under the ground, within their grade limits.
void place_endless_tunnels(const ProfileGraph& graph, std::span<const double> weight, std::vector<double>& z_m) {
  std::vector<double> under_m(z_m.size());
  const auto is_endless = [&](std::uint32_t n) {
    return weight[n] == 0 && !is_ground(graph, n) && is_in_tunnel(graph, n);
  };
  for (std::uint32_t n = 0; n < z_m.size(); ++n)
    if (is_endless(n)) under_m[n] = z_m[n] - kTunnelCover_m;
  under_m = lowered_to_limits(graph, under_m, {kSpanEndRadius_m, kSpanEndRadius_m});
  for (std::uint32_t n = 0; n < z_m.size(); ++n)
    if (is_endless(n)) z_m[n] = under_m[n];
}

}  // namespace

double filtered_height_m(const map::Heightfield& terrain, Vec2 p) {
  const double land_m = map::height_m_at(terrain, p);
  const auto [i, j, u, v] = map::cell_at(terrain, p);
  const int parts = terrain.parts, west = i / parts * parts, south = j / parts * parts;
  const auto corner = [&](int c) { return std::pair(west + c % 2 * parts, south + c / 2 * parts); };
  std::array<double, 4> z{};
  for (int c = 0; c < 4; ++c)
    z[static_cast<std::size_t>(c)] = terrain.height_m_at_vertex(corner(c).first, corner(c).second);
  // only a rectangle with a great difference of heights can have one such vertex
  constexpr double kSteep = 0.4;
  const auto [low, high] = std::ranges::minmax(z);
  if (high - low <= kSteep * std::max(terrain.longer_sample_step_m(), kMinSummit_m)) return land_m;
  for (int c = 0; c < 4; ++c) z[static_cast<std::size_t>(c)] = correction_m(terrain, corner(c).first, corner(c).second);
  const double east = (i - west + u) / parts, north = (j - south + v) / parts;
  return land_m + (east >= north ? z[0] + (z[1] - z[0]) * east + (z[3] - z[1]) * north
                                 : z[0] + (z[2] - z[0]) * north + (z[3] - z[2]) * east);
}

void interpolate_spans(const ProfileGraph& graph, std::vector<double>& z_m) {
  assert(z_m.size() == graph.nodes.size());
  std::vector<double> weighted_m(z_m.size()), weight(z_m.size());
  GraphWalk walk(graph);
  for (std::uint32_t n = 0; n < z_m.size(); ++n) {
    const auto goes_off = [&](const Leg& leg) { return graph.ways[leg.way].road == kNone; };
    if (!is_ground(graph, n) || !std::ranges::any_of(graph.legs_of(n), goes_off)) continue;
    walk.from(
        n, kSpanEndRadius_m, [&](const Leg& leg) { return goes_off(leg) ? leg.length_m : 2 * kSpanEndRadius_m; },
        [&](std::uint32_t node, double run_m) {
          if (node == n) return true;
          if (is_ground(graph, node)) return false;
          weighted_m[node] += z_m[n] / run_m;
          weight[node] += 1 / run_m;
          return true;
        });
  }
  for (std::uint32_t n = 0; n < z_m.size(); ++n)
    if (weight[n] > 0) z_m[n] = weighted_m[n] / weight[n];
  place_endless_tunnels(graph, weight, z_m);
}

std::vector<double> initial_heights(const ProfileGraph& graph, const map::Heightfield& heights,
                                    const LandformIndex& landforms) {
  std::vector<double> z_m;
  z_m.reserve(graph.nodes.size());
  for (const GraphNode& node : graph.nodes)
    z_m.push_back(with_landforms_m(landforms, node.at, filtered_height_m(heights, node.at)));
  interpolate_spans(graph, z_m);
  return z_m;
}

}  // namespace citykiln::ground
